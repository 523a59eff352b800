// coordinated: fires if every input holds a sample that arrived, all of one time of origin, later than the
// oldest that the component saw when it last fired. What it observes doesn't count.
#pragma once

#include <cca/component/strategy.hpp>

namespace cca {

struct coordinated {
  static constexpr bool needs_one_origin = true;

  static constexpr void add_name(auto& text) { text << "coordinated"; }
  static constexpr bool waits_in_vain(const detail::arrivals& inputs) {
    for (const auto& one : inputs)
      if (!one.observed) return false;
    return true;
  }

  template <class Inputs>
  static constexpr bool fires(beat, const Inputs& in) {
    return in.share_new_origin();
  }
};

}  // namespace cca
