// The beat: its index, its time and the time since a component last fired. Time is virtual; nothing reads a
// wall clock.
#pragma once

#include <cstdint>

#include <cca/base/assumed.hpp>

namespace cca {

class beat {
public:
  constexpr beat(std::int64_t index, std::int64_t period, std::int64_t beats_since)
      : k(index), T(period), since(beats_since) {}

  // k = 0, 1, 2, ...
  constexpr std::int64_t index() const { return detail::non_negative(k); }

  // Nanoseconds since beat 0.
  constexpr std::int64_t time() const { return k * T; }

  // Nanoseconds per beat.
  constexpr std::int64_t period() const { return T; }

  // Seconds since this component last fired (the first time: N beats for timed<N>, else one beat).
  constexpr double dt() const { return static_cast<double>(since * T) / 1e9; }

private:
  std::int64_t k, T, since;
};

}  // namespace cca
