// A fault on a bus in memory, and when it happens. A script is an array of faults.
//
//   {.what = bus_trouble::lose, .from = 100'000'000, .until = 200'000'000, .end = 1, .chance = 0.3}
//   from 0.1 s to 0.2 s, end 1 loses three in ten of the frames that others send
//
// lose, delay, duplicate, reorder and corrupt apply to the frames that `frames` matches, on their way to an
// end (`every_end`: to each end, with a chance of its own). warning, passive, bus_off and link_down apply to
// the end itself, for the whole time. A corrupt frame has one to four bits of its payload flipped, and one in
// four is also cut short. That is what a faulty gateway or drive does: errors on the wire are found by the
// checksum, and the frame is repeated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include <cca/hardware/bus/can_filter.hpp>

namespace cca::hardware {

enum class bus_trouble : std::uint8_t {
  lose,
  delay,
  duplicate,
  reorder,
  corrupt,
  warning,
  passive,
  bus_off,
  link_down
};

inline constexpr std::size_t every_end = std::numeric_limits<std::size_t>::max();

struct bus_fault {
  bus_trouble what = bus_trouble::lose;
  std::int64_t from = 0, until = std::numeric_limits<std::int64_t>::max();  // ns: from <= time < until
  std::size_t end = every_end;
  std::optional<can_filter> frames{};  // empty: all
  double chance = 1;                   // of each frame
  std::int64_t delay = 1'000'000;      // ns; for `reorder`: how long the frame waits at most to be overtaken

  constexpr bool concerns_end(std::size_t which) const { return end == every_end || end == which; }
  constexpr bool concerns(can_id id) const { return !frames || frames->matches(id); }
  constexpr bool now(std::int64_t time) const { return from <= time && time < until; }
};

}  // namespace cca::hardware
