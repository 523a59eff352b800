// The beat: its index, its time and the time since a component last fired. Time is virtual; nothing reads a
// wall clock. A test makes one from whole numbers: index, nanoseconds per beat, beats since it last fired.
// Errors: beat.not_whole.
#pragma once

#include <cstdint>
#include <type_traits>

#include <cca/base/assumed.hpp>
#include <cca/base/messages/holds_or_tells.hpp>

namespace cca {
namespace detail {
struct beat_of_seconds;

template <class... Numbers>
struct beat_not_whole {
  static constexpr void tell(text& m) {
    int place = 0, wrong = 0;
    ((++place, wrong = wrong == 0 && std::is_floating_point_v<Numbers> ? place : wrong), ...);
    m << "beat.not_whole: the "
      << (wrong == 1   ? "first"
          : wrong == 2 ? "second"
                       : "third")
      << " number of this beat is no whole number: a beat is made of its index, its period in nanoseconds "
         "and the number of beats since the component last fired, as in `cca::beat{3, 1000000, 1}`";
  }
};

}  // namespace detail

class beat {
public:
  constexpr beat(std::int64_t index, std::int64_t period, std::int64_t beats_since)
      : beat(index, period, seconds(period, beats_since)) {}

  // Made in a test, maybe from seconds: refused, since they would be cut to whole numbers.
  template <class Index, class Period, class Since>
    requires(std::is_floating_point_v<Index> || std::is_floating_point_v<Period> ||
             std::is_floating_point_v<Since>)
  constexpr beat(Index, Period, Since) : beat(0, 1, 1) {
    static_assert(detail::holds_or_tells<false, detail::beat_not_whole<Index, Period, Since>>::value);
  }

  // k = 0, 1, 2, ...
  constexpr std::int64_t index() const { return detail::non_negative(k); }

  // Nanoseconds since beat 0.
  constexpr std::int64_t time() const { return k * T; }

  // Nanoseconds per beat.
  constexpr std::int64_t period() const { return T; }

  // Seconds since this component last fired (the first time: N beats for timed<N>, else one beat).
  constexpr double dt() const { return since; }

private:
  friend struct detail::beat_of_seconds;
  struct duration {
    double in_seconds;
  };
  static constexpr duration seconds(std::int64_t period, std::int64_t beats) {
    return {static_cast<double>(beats * period) / 1e9};
  }
  constexpr beat(std::int64_t index, std::int64_t period, duration d)
      : k(index), T(period), since(d.in_seconds) {}

  std::int64_t k, T;
  double since;
};

namespace detail {

// A beat whose dt is known in seconds: where it is one of two constants, no beat divides.
struct beat_of_seconds {
  static constexpr double seconds(std::int64_t period, std::int64_t beats) {
    return beat::seconds(period, beats).in_seconds;
  }
  static constexpr beat make(std::int64_t index, std::int64_t period, double dt) {
    return beat(index, period, beat::duration{dt});
  }
};

}  // namespace detail

}  // namespace cca
