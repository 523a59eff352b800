// What two processes must have in common to run one deployment, as text: one fact a line. Numbers have all
// their digits, so limits that differ in the last bit differ here. Transports use it before a run.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iomanip>
#include <sstream>
#include <string>
#include <string_view>

#include <cca/component/parameter_check.hpp>
#include <cca/runtime/stoppable_parts.hpp>
#include <cca/runtime/each_component.hpp>
#include <cca/runtime/environments/exchange/exchange.hpp>
#include <cca/space/space_schema.hpp>
#include <cca/version.hpp>

namespace cca::detail {

// "legs: joint_angles of hip from -1.5 to 1.5 rad at 1000 Hz, schema 0123456789abcdef": the schema's hash
// covers what the words leave out.
inline void write_space(std::ostream& to, const space_info& space) {
  to << space.name << ": " << space.domain << " of";
  for (int a = 0; a < space.axis_count; ++a) {
    to << (a ? ", " : " ") << space.axes[a];
    if (space.lower) to << " from " << number_text(space.lower[a]) << " to " << number_text(space.upper[a]);
    if (!space.unit.empty()) to << ' ' << space.unit;
  }
  if (space.hz > 0) to << " at " << number_text(space.hz) << " Hz";
  to << ", schema " << std::hex << std::setw(16) << std::setfill('0') << space_schema(space).hash()
     << std::dec << std::setfill(' ');
}

// "delayed 3, initial 0.5", "delayed 1, queue of 4, drop_oldest": the policy of a wire.
inline void write_policy(std::ostream& to, const item_info& wire) {
  constexpr std::string_view full[] = {"drop_oldest", "drop_newest", "reject", "unknown"};
  if (wire.delay > 0) to << "delayed " << wire.delay << (wire.has_queue() ? ", " : "");
  else if (!wire.has_queue()) to << "latest";
  if (wire.has_queue())
    to << (wire.policy == policy_kind::merged ? "merged into a queue of " : "queue of ") << wire.capacity
       << ", " << full[static_cast<int>(wire.full)];
  if (!wire.initial) return;
  to << ", initial";
  for (int i = 0; i < wire.initial_count; ++i) to << ' ' << number_text(wire.initial[i]);
}

template <class D>
std::string manifest_of() {
  const auto& plan = plan_of<D>;
  const flat_view g = plan.view();
  std::ostringstream text;
  const auto port = [&](const auto& one) {
    return path_of_node<D>(g.calls[one.call].node) + "." + std::string(port_of(g, one).name);
  };
  text << "cca " << version_major << '.' << version_minor << '.' << version_patch << '\n'
       << "deployment " << g.scopes[0].graph->name << ", " << g.period << " ns a beat, "
       << sizeof(exchange<whole_of<D>>) << " bytes exchanged, " << environments_of<D>::tolerated
       << " late beats tolerated\n";
  for (int e = 0; e < environment_count<D>; ++e)
    text << "environment " << environments_of<D>::all[array_size(e)].name
         << (environments_of<D>::all[array_size(e)].is_free_running ? ", free-running\n" : "\n");
  for (int n = 0; n < g.node_count; ++n)
    text << "node " << path_of_node<D>(n) << ": " << g.nodes[n].item->component->name() << ", strategy "
         << g.nodes[n].item->strategy_key << ", in environment " << g.nodes[n].place << '\n';
  for (int p = 0; p < g.part_count; ++p) text << "part " << path_of_part<D>(p) << " may be stopped\n";
  for (int r = 0; r < g.request_count; ++r)
    text << "component " << path_of_node<D>(g.calls[g.requests[r].call].node)
         << (g.requests[r].starts ? " starts " : " stops ") << path_of_part<D>(g.requests[r].part) << '\n';
  for (int o = 0; o < g.output_count; ++o) {
    text << "output " << port(g.outputs[o]) << " in ";
    write_space(text, *port_of(g, g.outputs[o]).space);
    text << (g.outputs[o].watched ? ", observed\n" : "\n");
  }
  for (int i = 0; i < g.first_link; ++i)
    if (const auto& in = g.inputs[i]; in.wire && in.writer >= 0) {
      text << "wire from " << port(g.outputs[in.writer]) << " to " << port(in) << ": ";
      write_policy(text, *in.wire);
      text << ", read in ";
      write_space(text, *port_of(g, in).space);
      text << (in.watched ? ", observed\n" : "\n");
    }
  for (int l = 0; l < g.link_count; ++l) {
    const auto& heard = g.links[l];
    if (const auto& own = g.inputs[heard.observer]; own.outside) {
      text << "the program reads " << port(g.outputs[heard.output]) << ", " << own.delay << " beats later, ";
      write_policy(text, *own.wire);
      text << '\n';
      continue;
    }
    text << "observer " << port(g.inputs[heard.observer]) << " of "
         << (heard.input < 0 ? port(g.outputs[heard.output]) : "input " + port(g.inputs[heard.input]))
         << ", ";
    write_policy(text, port_of(g, g.inputs[heard.observer]).policy());
    text << '\n';
  }
  return text.str();
}

// Of a set of modes: that of each mode.
template <DeploymentOfModes D>
std::string manifest_of() {
  std::string text;
  for_each_deployed_mode<D>(
      [&]<class Mode>() { text += "mode " + std::string(Mode::cca_mode_name) + '\n' + manifest_of<Mode>(); });
  return text;
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

namespace cca {
using detail::first_difference;
using detail::manifest_of;
}  // namespace cca
