// strategy.misplaced: a strategy stands on a component, and a resource node runs at fixed beats.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct strategy_misplaced {
  static constexpr std::string_view id = "strategy.misplaced";

  static constexpr bool is_broken(when::stated_strategy, const flat_view&, const finding& f) {
    return f.item->kind == item_kind::graph ||
           (f.item->component->resource() && !f.item->strategy->for_resource_nodes);
  }

  static constexpr void tell(auto& m) {
    m.at_node();
    m.node();
    if (m.item().inner)
      m.say() << " is a graph, and a strategy stands on components: give it to the nodes inside";
    else
      m.say() << " is a resource node, which runs at fixed beats: it may be cca::timed, cca::full_speed or "
                 "cca::inactive";
  }
};

}  // namespace cca::detail
