// cca-can pretend: plays drives and their faults on a bus, to try the rest without a robot: `ip link add
// vcan0 type vcan`.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "../drives/any_drive.hpp"
#include "../ending.hpp"
#include "../pace.hpp"

namespace cca_can {

// Hears all that has come, and answers it.
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

// Times in s from the start.
struct pretend_order {
  double seconds = 0;  // 0: until ctrl-c
  std::optional<double> silent_at{}, fault_at{};
  double silent_for = 0;   // 0: for good
  std::uint32_t code = 0;  // the firmware's number of the fault
  double load = 0;         // N m on each motor
};

template <hw::CanBus Bus>
ending pretend(Bus& bus,
               const std::vector<std::unique_ptr<any_virtual>>& drives,
               const pretend_order& o,
               pace& time) {
  const std::int64_t from = time.now();
  bool failed_once = false;
  for (const auto& drive : drives) drive->load = o.load;
  for (double t = 0; !time.end_wanted() && (o.seconds == 0 || t < o.seconds);
       t = static_cast<double>(time.now() - from) * 1e-9) {
    const bool silent =
        o.silent_at && t >= *o.silent_at && (o.silent_for == 0 || t < *o.silent_at + o.silent_for);
    const bool fails = o.fault_at && t >= *o.fault_at && !failed_once;
    failed_once = failed_once || fails;
    for (const auto& drive : drives) {
      drive->go_silent(silent);
      if (fails) drive->fail(o.code);
    }
    play(bus, drives, time.now());
    time.wait_until(time.now() + ms / 2);
  }
  return done;
}

}  // namespace cca_can
