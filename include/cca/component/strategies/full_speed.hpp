// full_speed: fires in every beat.
#pragma once

#include <cca/component/strategy.hpp>

namespace cca {

struct full_speed {
  static constexpr detail::clock clock = detail::every(1);
  static constexpr bool for_resource_nodes = true;

  static constexpr void add_name(auto& text) { text << "full_speed"; }

  template <class Inputs>
  static constexpr bool fires(beat, const Inputs&) {
    return true;
  }
};

}  // namespace cca
