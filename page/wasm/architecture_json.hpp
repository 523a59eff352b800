// The architecture of a graph as JSON, computed from its type: what the page draws.
//
//   environments  their names, of a deployment
//
//   nodes         path, whether it is a resource node, when it fires; its clock, if known; its environment
//
//   outputs       path, node, space with domain, rate and coordinates, place in a row
//
//   wires         number of the output, node and name of the input, policy, delay
#pragma once

#include <string>

#include <cca/graph/deployment/environments.hpp>
#include <cca/runtime/each_component.hpp>
#include <cca/space/space_schema.hpp>

#include "json_text.hpp"

namespace cca::page {

// When a component fires: its clock as a rate, or its strategy.
inline std::string when(const detail::flat_view& g, int node) {
  const auto& call = g.calls[g.nodes[node].first_call];
  detail::text name;
  if (g.hz > 0 && call.fires.known()) name << g.hz / static_cast<double>(call.fires.period) << " Hz";
  else detail::strategy_of_call(g, call).add_name(name);
  return std::string(name.view());
}

inline std::string policy(const detail::input& in) {
  switch (in.wire->policy) {
    case detail::policy_kind::delayed:
      return "delayed " + std::to_string(in.wire->number);
    case detail::policy_kind::queue:
      return "queue " + std::to_string(in.wire->number);
    default:
      return "latest";
  }
}

inline void add_space(json_text& json, const detail::space_info& of) {
  const space_schema space(of);
  json.key("space").add(of.name).key("domain").add(of.domain).key("hz").add(space.hz());
  json.key("fields").open('[');
  for (int i = 0; i < space.field_count(); ++i) {
    const schema_field f = space.field(i);
    json.open('{').key("name").add(f.name()).key("unit").add(f.unit);
    json.key("lower").add(f.lower).key("upper").add(f.upper).close('}');
  }
  json.close(']');
}

template <class Graph>
void add_architecture(json_text& json, std::string_view title) {
  auto plan = detail::plan_of<Graph>;
  const detail::flat_view g = plan.view();
  json.key("name").add(title).key("period").add(g.period);
  json.key("environments").open('[');
  for (int e = 0; g.is_spread && e < detail::placement_in(g).count; ++e)
    json.add(detail::environment_in(g, e).name);
  json.close(']').key("nodes").open('[');
  for (int n = 0; n < g.node_count; ++n) {
    json.open('{')
        .key("path")
        .add(detail::path_of_node<Graph>(n))
        .key("resource")
        .add(g.nodes[n].item->component->resource())
        .key("when")
        .add(when(g, n))
        .key("environment")
        .add(g.nodes[n].place);
    if (const auto& fires = g.calls[g.nodes[n].first_call].fires; fires.known())
      json.key("clock").open('{').key("period").add(fires.period).key("first").add(fires.first).close('}');
    json.close('}');
  }
  json.close(']').key("outputs").open('[');
  int at = 0;
  for (int o = 0; o < g.output_count; ++o) {
    const auto& port = detail::port_of(g, g.outputs[o]);
    const int node = g.calls[g.outputs[o].call].node;
    json.open('{').key("path").add(detail::path_of_node<Graph>(node) + "." + std::string(port.name));
    json.key("node").add(node).key("at").add(at);
    add_space(json, *port.space);
    json.close('}');
    at += port.space->size;
  }
  json.close(']').key("wires").open('[');
  for (int i = 0; i < g.input_count; ++i)
    if (const auto& in = g.inputs[i]; in.writer >= 0)
      json.open('{')
          .key("from")
          .add(in.writer)
          .key("node")
          .add(g.calls[in.call].node)
          .key("input")
          .add(detail::port_of(g, in).name)
          .key("policy")
          .add(policy(in))
          .key("delay")
          .add(in.delay)
          .close('}');
  json.close(']');
}

}  // namespace cca::page
