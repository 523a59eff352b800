// inactive: never fires.
#pragma once

#include <cca/component/strategy.hpp>

namespace cca {

struct inactive {
  static constexpr detail::clock clock = detail::never_clock;
  static constexpr bool for_resource_nodes = true;

  static constexpr void add_name(auto& text) { text << "inactive"; }

  template <class Inputs>
  static constexpr bool fires(beat, const Inputs&) {
    return false;
  }
};

}  // namespace cca
