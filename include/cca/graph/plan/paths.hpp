// Writes paths, spaces and clocks for messages and pictures.
#pragma once

#include <cca/graph/plan/flat.hpp>
#include <cca/base/text.hpp>

namespace cca::detail {

constexpr void add_scope_path(text& t, const flat_view& g, int s) {
  if (!g.scopes[s].item) return;
  add_scope_path(t, g, g.scopes[s].parent);
  t << g.scopes[s].item->from << ".";
}

// "dmp.criterion"
constexpr void add_node_path(text& t, const flat_view& g, int node_index) {
  add_scope_path(t, g, g.nodes[node_index].scope);
  t << g.nodes[node_index].item->from;
}

// "dmp.criterion.error"
constexpr void add_port(text& t, const flat_view& g, const input& i) {
  add_node_path(t, g, g.calls[i.call].node);
  t << "." << port_of(g, i).name;
}
constexpr void add_port(text& t, const flat_view& g, const output& o) {
  add_node_path(t, g, g.calls[o.call].node);
  t << "." << port_of(g, o).name;
}

// "leg_angles (joint_angles over hip, knee at 1000 Hz)"
constexpr void add_space(text& t, const space_info& space) {
  t << space.name << " (" << space.domain << " over ";
  for (int a = 0; a < space.axis_count; ++a) t << (a ? ", " : "") << space.axes[a];
  if (space.hz > 0) t << " at " << space.hz << " Hz";
  t << ")";
}

constexpr void add_clock(text& t, clock c) {
  if (c.never()) t << "never";
  else if (c.dynamic()) t << "at beats known only at run time";
  else {
    if (c.period == 1) t << "every beat";
    else t << "every " << c.period << " beats";
    if (c.first > 0) t << " from beat " << c.first;
  }
}

}  // namespace cca::detail
