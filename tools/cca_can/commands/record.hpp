// cca-can record: writes the frames on a bus as `candump -L` does.
#pragma once

#include <array>
#include <ostream>
#include <string>

#include <cca/hardware/can_bus.hpp>

#include "../console.hpp"
#include "../log_line.hpp"
#include "../pace.hpp"

namespace cca_can {

// 0: without end.
struct record_order {
  double seconds = 0;
  std::uint64_t frames = 0;
};

template <hw::CanBus Bus>
ending record(
    Bus& bus, const std::string& name, const record_order& o, std::ostream& file, pace& time, console& say) {
  const std::int64_t from = time.now(), to_calendar = time.calendar() - from;
  std::uint64_t n = 0;
  const auto enough = [&] { return o.frames != 0 && n >= o.frames; };
  while (!time.end_wanted() && !enough() && file &&
         (o.seconds == 0 || static_cast<double>(time.now() - from) < o.seconds * 1e9)) {
    time.wait_until(time.now() + ms);
    std::array<hw::received_frame, 32> frames;
    for (std::size_t got = frames.size(); got == frames.size();) {
      got = bus.receive(frames);
      for (std::size_t i = 0; i < got && !enough(); ++i, ++n)
        file << text_of(log_line{.time = frames[i].time + to_calendar, .bus = name, .frame = frames[i].frame})
             << '\n';
    }
  }
  file.flush();
  say.error << n << " frames recorded";
  if (const auto lost = bus.counters().lost; lost > 0)
    say.error << ", " << lost << " lost: the machine was too slow";
  say.error << '\n';
  if (!file) {
    say.error << "cca-can: the file could not be written to its end\n";
    return refused;
  }
  return bus.counters().lost > 0 ? failed : done;
}

}  // namespace cca_can
