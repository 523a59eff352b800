// What goes wrong on a bus in memory, and when: a script is an array of these.
//
//   {.what = bus_trouble::lose, .from = 100'000'000, .until = 200'000'000, .end = 1, .chance = 0.3}
//   from 0.1 s to 0.2 s the end 1 does not get three in ten of the frames that others send.
//
// lose, delay, duplicate, reorder and corrupt happen to frames of `frames` on their way to an end
// (`every_end`: to each of them, each by its own chance); warning, passive, bus_off and link_down to an end
// itself, for the whole time. A corrupt frame has one to four bits of its payload turned, and one in four is
// cut short besides: what a faulty gateway or drive does, since what happens on the wire is found by the
// checksum and repeated.
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
  std::int64_t from = 0, until = std::numeric_limits<std::int64_t>::max();  // ns, the latter no more
  std::size_t end = every_end;
  std::optional<can_filter> frames{};  // empty: all
  double chance = 1;                   // of each frame
  std::int64_t delay =
      1'000'000;  // ns; of `reorder` the longest that a frame waits for the next one to overtake it

  constexpr bool concerns_end(std::size_t which) const { return end == every_end || end == which; }
  constexpr bool concerns(can_id id) const { return !frames || frames->matches(id); }
  constexpr bool now(std::int64_t time) const { return from <= time && time < until; }
};

}  // namespace cca::hardware
