// moderate: fires if every input is fresh.
#pragma once

#include <cca/component/arrival_clocks.hpp>
#include <cca/component/strategy.hpp>

namespace cca {

struct moderate {
  static constexpr bool fires_on_arrival = true;

  static constexpr void add_name(auto& text) { text << "moderate"; }
  static constexpr detail::clock clock_from(const detail::arrivals& inputs) {
    return detail::every_arrival(inputs);
  }
  static constexpr bool waits_in_vain(const detail::arrivals& inputs) { return inputs.count == 0; }

  template <class Inputs>
  static constexpr bool fires(beat, const Inputs& in) {
    return in.all_fresh();
  }
};

}  // namespace cca
