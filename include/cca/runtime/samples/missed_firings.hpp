// When a component of a clock that is known only at run time fired last. And what one of known clock did not
// do: a fault ended the beat before its turn, or its environment left the beat out. So its next firing comes
// later after the last one than its clock says.
//
// What was missed is noted when a beat has ended early, outside of it. A beat asks once whether anything was
// missed not long ago. Cost: in a graph that may fault this test, and one of its result in each component of
// known clock that a fault may keep from firing and that reads now.dt() or fresh(); elsewhere nothing.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include <cca/base/array_size.hpp>
#include <cca/base/inlining.hpp>
#include <cca/space/origin.hpp>

namespace cca::detail {

// Of a component whose clock is known only at run time.
struct last_firing {
  std::int64_t last = -1;       // beat; -1: it has not fired yet
  std::int64_t oldest = never;  // origin that it saw then
  bool is_first = true;         // of a part: it has not fired since that was started
};
template <int Count>
struct last_firings {
  last_firing firings[array_size(Count)]{};
};
template <>
struct last_firings<0> {};

inline constexpr int all_turns = std::numeric_limits<int>::max();

struct missed_firing {
  std::int64_t in = -1;    // the last beat in which it should have fired and did not
  std::int64_t last = -1;  // in which it had fired before; -1: none
  std::int64_t beats = 0;  // from then until `in`
};

template <int Count>
struct missed_firings {
  std::int64_t missed_until = 0;  // in an earlier beat a component may fire for the first time after a miss
  std::array<missed_firing, array_size(Count)> missed{};
};
template <>
struct missed_firings<0> {};

// In a beat.
template <int Count>
struct after_missed {
  bool is_after_missed;
  CCA_INLINE after_missed(const missed_firings<Count>& now, std::int64_t k)
      : is_after_missed(k < now.missed_until) {}
};
template <>
struct after_missed<0> {
  CCA_INLINE after_missed(const missed_firings<0>&, std::int64_t) {}
};

// The beat in which it fired last, by its clock `tick`.
template <int Count>
std::int64_t last_fired(const missed_firings<Count>& now, int number, std::int64_t tick) {
  const missed_firing& one = now.missed[array_size(number)];
  return one.in == tick ? one.last : tick;
}

}  // namespace cca::detail
