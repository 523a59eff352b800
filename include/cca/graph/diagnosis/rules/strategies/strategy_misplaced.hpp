// strategy.misplaced: a strategy stands on a component, a graph is at most stoppable, and a resource node
// runs at fixed beats as long as its controller does.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct strategy_misplaced {
  static constexpr std::string_view id = "strategy.misplaced";

  static constexpr bool is_broken(when::stated_strategy, const flat_view&, const finding& f) {
    if (f.item->kind == item_kind::graph) return !f.item->is_stoppable() || f.item->strategy_while_started();
    return f.item->component->resource() && !f.item->strategy->for_resource_nodes;
  }
  static constexpr bool is_broken(when::node_of_part, const flat_view&, const finding& f) {
    return f.item->component->resource();
  }

  static constexpr void tell(auto& m) {
    m.at_node();
    m.node();
    if (m.item().inner && m.item().is_stoppable())
      m.say() << " is a graph, which is cca::stoppable<> without a strategy: give the strategy to the nodes "
                 "inside";
    else if (m.item().inner)
      m.say() << " is a graph, and a strategy stands on components: give it to the nodes inside";
    else if (!m.item().strategy || m.item().strategy->for_resource_nodes)
      m.say() << " is a resource node, which stops only with its controller, but the graph around it is "
                 "cca::stoppable<>: move the resource node out of that graph";
    else
      m.say() << " is a resource node, which runs at fixed beats: it may be cca::timed, cca::full_speed or "
                 "cca::inactive";
  }
};

}  // namespace cca::detail
