// "Did you mean ...": the port of a graph whose name is nearest to a wrong one.
#pragma once

#include <cca/base/nearest.hpp>
#include <cca/base/text.hpp>
#include <cca/graph/plan/flat.hpp>

namespace cca::detail {

// Does a graph expose an output under this name (else it is an input)?
constexpr bool is_output_named(const graph_info& graph, std::string_view shown) {
  const auto node = shown.substr(0, shown.find('.')), port = shown.substr(shown.find('.') + 1);
  for (int i = 0; i < graph.count; ++i) {
    const auto& item = graph.items[i];
    if (item.from != node) continue;
    if (item.component)
      for (const auto function : functions_of(*item.component))
        for (int p = 0; function && p < function->output_count; ++p)
          if (function->outputs[p].name == port) return true;
    for (int e = 0; item.inner && e < item.inner->count; ++e)
      if (const auto& inner = item.inner->items[e];
          inner.kind == item_kind::expose && inner.to == port && is_output_named(*item.inner, inner.from))
        return true;
  }
  return false;
}

// The port nearest to a wrong name, of those that a wire in this graph can name; empty if none is near.
constexpr text nearest_port(const graph_info& graph, std::string_view wrong, bool outputs) {
  text best;
  std::size_t least = wrong.size() / 3 + 2;
  const auto consider = [&](std::string_view node, std::string_view port) {
    const auto size = node.size() + 1 + port.size();
    if ((size < wrong.size() ? wrong.size() - size : size - wrong.size()) >= least) return;
    text candidate;
    candidate << node << "." << port;
    if (const auto distance = edit_distance(wrong, candidate.view()); distance < least) {
      least = distance;
      best = candidate;
    }
  };
  for (int i = 0; i < graph.count; ++i) {
    const auto& item = graph.items[i];
    if (item.kind == item_kind::node)
      for (const auto function : functions_of(*item.component))
        for (int p = 0; function && p < (outputs ? function->output_count : function->input_count); ++p)
          if (const auto& port = (outputs ? function->outputs : function->inputs)[p]; outputs || port.space)
            consider(item.from, port.name);
    if (item.kind == item_kind::graph)
      for (int e = 0; e < item.inner->count; ++e)
        if (const auto& inner = item.inner->items[e];
            inner.kind == item_kind::expose && is_output_named(*item.inner, inner.from) == outputs)
          consider(item.from, inner.to);
  }
  return best;
}

}  // namespace cca::detail
