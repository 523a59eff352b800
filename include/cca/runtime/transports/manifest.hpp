// What two processes must have in common to run one deployment, as text: one fact a line.
#pragma once

#include <sstream>
#include <string>
#include <string_view>

#include <cca/runtime/each_component.hpp>
#include <cca/runtime/environments/exchange.hpp>
#include <cca/version.hpp>

namespace cca::detail {

// "x, y; joint_angles; -1.5 to 1.5, ...": the axes, the domain type and the limits.
inline void write_space(std::ostream& to, const space_info& space) {
  to << space.name << ": " << space.domain << " of";
  for (int a = 0; a < space.axis_count; ++a) {
    to << (a ? ", " : " ") << space.axes[a];
    if (space.lower) to << " from " << space.lower[a] << " to " << space.upper[a];
  }
  if (space.hz > 0) to << " at " << space.hz << " Hz";
}

template <class D>
std::string manifest_of() {
  auto plan = plan_of<D>;
  const flat_view g = plan.view();
  std::ostringstream text;
  text << "cca " << version_major << '.' << version_minor << '.' << version_patch << '\n'
       << "deployment " << g.scopes[0].graph->name << ", " << g.period << " ns a beat, "
       << sizeof(exchange<D>) << " bytes exchanged, " << environments_of<D>::tolerated
       << " late beats tolerated\n";
  for (int e = 0; e < environment_count<D>; ++e)
    text << "environment " << environments_of<D>::all[array_size(e)].name << '\n';
  for (int n = 0; n < g.node_count; ++n)
    text << "node " << path_of_node<D>(n) << ": " << g.nodes[n].item->component->name() << ", strategy "
         << g.nodes[n].item->strategy_key << ", in environment " << g.nodes[n].environment << '\n';
  for (int o = 0; o < g.output_count; ++o) {
    text << "output " << path_of_node<D>(g.calls[g.outputs[o].call].node) << '.'
         << port_of(g, g.outputs[o]).name << " in ";
    write_space(text, *port_of(g, g.outputs[o]).space);
    text << '\n';
  }
  for (int i = 0; i < g.input_count; ++i)
    if (const auto& in = g.inputs[i]; in.writer >= 0)
      text << "wire to " << path_of_node<D>(g.calls[in.call].node) << '.' << port_of(g, in).name
           << " from output " << in.writer << ", delayed " << in.delay << '\n';
  return text.str();
}

// The first line in which they differ: "here ..., there ...".
inline std::string first_difference(std::string_view here, std::string_view there) {
  const auto line = [](std::string_view& text) {
    const auto end = std::min(text.find('\n'), text.size());
    const auto one = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return one;
  };
  while (!here.empty() || !there.empty()) {
    const auto a = line(here), b = line(there);
    if (a != b)
      return "here `" + std::string(a.empty() ? "nothing" : a) + "`, there `" +
             std::string(b.empty() ? "nothing" : b) + "`";
  }
  return {};
}

}  // namespace cca::detail
