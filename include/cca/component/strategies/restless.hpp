// restless: fires if any input is fresh. The default of components with inputs.
#pragma once

#include <cca/component/arrival_clocks.hpp>
#include <cca/component/strategy.hpp>

namespace cca {

struct restless {
  static constexpr bool fires_on_arrival = true;

  static constexpr void add_name(auto& text) { text << "restless"; }
  static constexpr detail::clock clock_from(const detail::arrivals& inputs) {
    return detail::any_arrival(inputs);
  }
  static constexpr bool waits_in_vain(const detail::arrivals& inputs) { return inputs.count == 0; }

  template <class Inputs>
  static constexpr bool fires(beat, const Inputs& in) {
    return in.any_fresh();
  }
};

}  // namespace cca
