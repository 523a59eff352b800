// cca-can pretend: plays drives on a bus, for trying the rest without a robot: `ip link add vcan0 type vcan`.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "any_drive.hpp"
#include "ending.hpp"
#include "pace.hpp"

namespace cca_can {

// What came is heard, and answered.
template <hw::CanBus Bus>
void play(Bus& bus, const std::vector<std::unique_ptr<any_virtual>>& drives, std::int64_t now) {
  std::array<hw::received_frame, 32> frames;
  for (std::size_t n = frames.size(); n == frames.size();) {
    n = bus.receive(frames);
    for (std::size_t i = 0; i < n; ++i)
      for (const auto& drive : drives) drive->hear(frames[i].frame, now);
  }
  for (const auto& drive : drives)
    if (const hw::drive_frames answers = drive->advance(now); !answers.empty()) bus.send(answers);
}

// 0 s: until ctrl-c.
template <hw::CanBus Bus>
ending pretend(Bus& bus, const std::vector<std::unique_ptr<any_virtual>>& drives, double seconds, pace& time) {
  const std::int64_t from = time.now();
  while (!time.end_wanted() && (seconds == 0 || static_cast<double>(time.now() - from) < seconds * 1e9)) {
    play(bus, drives, time.now());
    time.wait_until(time.now() + ms / 2);
  }
  return done;
}

}  // namespace cca_can
