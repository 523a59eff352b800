// timeout<N>: fires if N beats have passed since the component last fired, or since beat 0 if it never did.
// N is at least 1. Meant for any_of<moderate, timeout<15>>.
#pragma once

#include <cstdint>

#include <cca/component/beat_count.hpp>
#include <cca/component/strategy.hpp>

namespace cca {

template <std::int64_t N>
struct timeout {
  // Alone it counts from its own firings; in a combination these depend on the other strategies.
  static constexpr detail::clock clock{N < 1 ? 0 : N, N};
  static constexpr detail::clock clock_in_combination = detail::dynamic_clock;
  static constexpr std::string_view mistake = detail::too_few_beats(N);

  static constexpr void add_name(auto& text) { text << "timeout<" << N << ">"; }

  template <class Inputs>
  static constexpr bool fires(beat, const Inputs& in) {
    return in.beats_since_fired() >= N;
  }
};

}  // namespace cca
