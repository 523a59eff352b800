// timed<N, Phase>: fires in beat k if (k - Phase) mod N = 0. N is at least 1.
#pragma once

#include <cstdint>

#include <cca/component/beat_count.hpp>
#include <cca/component/strategy.hpp>

namespace cca {

template <std::int64_t N, std::int64_t Phase = 0>
struct timed {
  static constexpr detail::clock clock = detail::every(N, Phase);
  static constexpr std::string_view mistake = detail::too_few_beats(N);
  static constexpr bool for_resource_nodes = true, first_dt_is_period = true;

  static constexpr void add_name(auto& text) {
    text << "timed<" << N;
    if (Phase != 0) text << ", " << Phase;
    text << ">";
  }

  template <class Inputs>
  static constexpr bool fires(beat now, const Inputs&) {
    return detail::ticks(clock, now.index());
  }
};

}  // namespace cca
