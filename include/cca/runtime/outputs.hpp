// The outputs of a graph, a deployment or a set of modes, by number: path, node and space.
#pragma once

#include <string>

#include <cca/base/array_size.hpp>
#include <cca/runtime/each_component.hpp>

namespace cca::detail {

template <class Graph>
int node_of_output(int output) {
  return plan_of<Graph>.calls[array_size(plan_of<Graph>.outputs[array_size(output)].call)].node;
}

// "dmp.ode.phase"
template <class Graph>
std::string path_of_output(int output) {
  const auto& o = plan_of<Graph>.outputs[array_size(output)];
  const auto& call = plan_of<Graph>.calls[array_size(o.call)];
  return path_of_node<Graph>(call.node) + "." + std::string(call.function->outputs[o.port].name);
}

template <class Graph>
const space_info& space_of_output(int output) {
  const auto& o = plan_of<Graph>.outputs[array_size(output)];
  return *plan_of<Graph>.calls[array_size(o.call)].function->outputs[o.port].space;
}

}  // namespace cca::detail
