// part.unknown_path: what a component stops or starts is a part, a node that may be stopped.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct part_unknown_path {
  static constexpr std::string_view id = "part.unknown_path";

  static constexpr bool is_broken(when::unknown_part, const flat_view&, const finding&) { return true; }

  static constexpr void tell(auto& m) {
    const auto wanted = m.found().name;
    m.at_node();
    m.node();
    m.say() << " stops or starts `" << wanted << "`, ";
    if (!m.found().why.empty()) {
      m.say() << m.found().why;
      return;
    }
    if (const auto found = find_named(m.g, m.found().scope, wanted); found.is_there) {
      m.say() << "but its node does not let it be stopped: write "
              << (found.is_graph ? "cca::stoppable<> as the strategy of the graph"
                                 : "cca::stoppable<...> around its strategy");
      return;
    }
    m.say() << "but there is no node of this path in its graph, nor in the graphs around it";
    std::string_view best;
    std::size_t least = 1 + wanted.size() / 2;
    for (int p = 0; p < m.g.part_count; ++p)
      if (const auto distance = edit_distance(wanted, m.g.parts[p].item->from); distance < least) {
        least = distance;
        best = m.g.parts[p].item->from;
      }
    if (!best.empty()) m.say() << "; did you mean `" << best << "`?";
    else m.say() << ": name a node that has cca::stoppable<...>";
  }

private:
  struct named {
    bool is_there = false, is_graph = false;
  };
  static constexpr named find_named(const flat_view& g, int from, std::string_view path) {
    for (int s = from; s >= 0; s = g.scopes[s].parent) {
      const auto wanted = path_hash(g.scopes[s], path, hash(path));
      for (int inner = 1; inner < g.scope_count; ++inner)
        if (g.scopes[inner].hash == wanted) return {true, true};
      for (int n = 0; n < g.node_count; ++n)
        if (path_hash(g.scopes[g.nodes[n].scope], g.nodes[n].item->from, g.nodes[n].item->from_hash) ==
            wanted)
          return {true, false};
    }
    return {};
  }
};

}  // namespace cca::detail
