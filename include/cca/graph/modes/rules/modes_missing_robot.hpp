// modes.missing_robot: every mode has all resource nodes. In a mode without one its robot would be
// neither driven nor stopped.
#pragma once

#include <cca/graph/modes/events_of_modes.hpp>

namespace cca::detail {

struct modes_missing_robot {
  static constexpr std::string_view id = "modes.missing_robot";

  static constexpr bool is_broken(when::missing_node, const flat_view&, const finding& f) {
    return f.item->component->resource();
  }

  static constexpr void tell(auto& m) {
    m.at_node();
    m.say() << "the resource node ";
    m.node();
    m.say() << " is in ";
    m.mode(in_mode(m.found()));
    m.say() << " but not in ";
    m.mode(other_mode(m.found()));
    m.say() << ", so after a switch nothing would command it or go on stopping it: put it into every mode, "
               "under the same path";
  }
};

}  // namespace cca::detail
