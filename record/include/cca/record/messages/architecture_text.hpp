// An architecture as text, one fact a line, and its hash: what a recording and the program that replays it
// must have in common.
#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <sstream>
#include <string>

#include <cca/graph/deployment/environments.hpp>
#include <cca/graph/items/modes.hpp>
#include <cca/runtime/stoppable_parts.hpp>
#include <cca/runtime/each_component.hpp>
#include <cca/space/space_schema.hpp>

namespace cca::recording::detail {

template <class Graph>
std::string architecture_text();

// A set of modes: that of each mode, one after the other.
template <class Graph>
  requires Modes<Graph>
std::string architecture_text() {
  std::string text;
  [&]<fixed_string... Name, class... G>(cca::detail::list<mode<Name, G>...>) {
    (text.append("mode ").append(Name.view()).append("\n").append(architecture_text<G>()), ...);
  }(typename Graph::cca_modes{});
  return text;
}

template <class Graph>
std::string architecture_text() {
  using namespace cca::detail;
  const auto& plan = plan_of<Graph>;
  const flat_view g = plan.view();
  std::ostringstream text;
  text << g.period << " ns a beat\n";
  // Clocks and no names of types, which each compiler spells in its own way.
  for (int n = 0; n < g.node_count; ++n) {
    const auto& fires = g.calls[g.nodes[n].first_call].fires;
    text << "node " << path_of_node<Graph>(n);
    if (fires.dynamic()) text << ", fires by what arrives\n";
    else if (fires.never()) text << ", never fires\n";
    else text << ", fires every " << fires.period << " beats from " << fires.first << '\n';
  }
  for (int p = 0; p < g.part_count; ++p) text << "part " << path_of_part<Graph>(p) << " may be stopped\n";
  for (int r = 0; r < g.request_count; ++r)
    text << "component " << path_of_node<Graph>(g.calls[g.requests[r].call].node)
         << (g.requests[r].starts ? " starts " : " stops ") << path_of_part<Graph>(g.requests[r].part)
         << '\n';
  for (int o = 0; o < g.output_count; ++o) {
    const space_schema space(*port_of(g, g.outputs[o]).space);
    text << "output " << path_of_node<Graph>(g.calls[g.outputs[o].call].node) << '.'
         << port_of(g, g.outputs[o]).name << ": " << space.field_count() << " numbers, space " << space.hash()
         << '\n';
  }
  for (int i = 0; i < g.input_count; ++i)
    if (const auto& in = g.inputs[i]; in.writer >= 0)
      text << "wire to " << path_of_node<Graph>(g.calls[in.call].node) << '.' << port_of(g, in).name
           << " from output " << in.writer << ", delayed " << in.delay << '\n';
  return text.str();
}

// Of a deployment: the environment of each component.
template <class Graph>
std::map<std::string, std::string> places_of() {
  auto plan = cca::detail::plan_of<Graph>;
  const cca::detail::flat_view g = plan.view();
  std::map<std::string, std::string> places;
  for (int n = 0; n < g.node_count; ++n)
    if (const int e = g.nodes[n].place; e >= 0)
      places[cca::detail::path_of_node<Graph>(n)] = std::string(cca::detail::environment_in(g, e).name);
  return places;
}

inline std::string hash_of_architecture(const std::string& text) {
  char digits[20];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(cca::detail::hash(text)));
  return digits;
}

}  // namespace cca::recording::detail
