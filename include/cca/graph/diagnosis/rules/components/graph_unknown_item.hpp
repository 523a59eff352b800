// graph.unknown_item: a graph consists of known items.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct graph_unknown_item {
  static constexpr std::string_view id = "graph.unknown_item";

  static constexpr bool is_broken(when::any_item, const flat_view&, const finding& f) {
    return f.item->kind == item_kind::unknown;
  }

  static constexpr void tell(auto& m) {
    m.where << m.graph().name;
    m.say()
        << "`" << m.item().unknown_type << "` in " << m.graph().name
        << " is no item of a graph, so it would be ignored: write cca::node<`name`, type> for a component or "
           "graph; the others are cca::wire, cca::expose, cca::observe, cca::rate and "
           "cca::require<cca::latency<...>, cca::beats<N>>";
  }
};

}  // namespace cca::detail
