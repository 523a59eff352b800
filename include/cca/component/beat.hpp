// The beat: its index, its time and the time since a component last fired. Time is virtual; nothing reads a
// wall clock. A test makes one from whole numbers: index, nanoseconds per beat, beats since it last fired.
// Errors: beat.not_whole.
#pragma once

#include <cstdint>
#include <type_traits>

#include <cca/base/assumed.hpp>

namespace cca {

class beat {
public:
  constexpr beat(std::int64_t index, std::int64_t period, std::int64_t beats_since)
      : k(index), T(period), since(beats_since) {}

  // Made in a test, maybe from seconds: refused, since they would be cut to whole numbers.
  template <class Index, class Period, class Since>
    requires(std::is_floating_point_v<Index> || std::is_floating_point_v<Period> ||
             std::is_floating_point_v<Since>)
  constexpr beat(Index, Period, Since) : beat(0, 1, 1) {
    static_assert(!sizeof(Index),
                  "beat.not_whole: a beat is made of whole numbers: its index, its period in nanoseconds and "
                  "the number of beats since the component last fired, as in `cca::beat{3, 1'000'000, 1}`");
  }

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
