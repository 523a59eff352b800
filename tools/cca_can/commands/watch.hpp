// cca-can watch: prints what drives report. It only listens; with --ask it asks by frames that can't move
// them.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "../console.hpp"
#include "../drives/talk.hpp"

namespace cca_can {

// 0 s: until ctrl-c.
template <hw::CanBus Bus>
ending watch(Bus& bus,
             const std::vector<std::unique_ptr<any_drive>>& drives,
             bool ask,
             double seconds,
             pace& time,
             console& say) {
  std::vector<hw::drive_report> told(drives.size());
  const std::int64_t from = time.now();
  std::int64_t shown = from + 200 * ms;
  std::vector<std::uint64_t> before(drives.size());
  bool all_answered = true;
  while (seconds == 0 || static_cast<double>(time.now() - from) < seconds * 1e9) {
    if (ask)
      for (const auto& drive : drives) bus.send(drive->ask_state());
    time.wait_until(time.now() + 20 * ms);
    std::array<hw::received_frame, 32> frames;
    for (std::size_t n = frames.size(); n == frames.size();) {
      n = bus.receive(frames);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < drives.size(); ++k) drives[k]->decode(frames[i].frame, told[k]);
    }
    if (time.end_wanted()) break;
    if (time.now() < shown) continue;
    shown = time.now() + 500 * ms;
    if (bus.state() != hw::bus_state::active) say.out << "the bus is " << name_of(bus.state()) << '\n';
    all_answered = true;
    for (std::size_t k = 0; k < drives.size(); ++k) {
      const bool silent = told[k].frames == before[k];
      before[k] = told[k].frames;
      all_answered = all_answered && !silent;
      say.out << drives[k]->text << "  " << (silent ? std::string("silent") : text_of(told[k])) << '\n';
    }
    say.out << std::flush;
  }
  return all_answered ? done : failed;
}

}  // namespace cca_can
