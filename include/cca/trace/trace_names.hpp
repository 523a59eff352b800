// What a trace calls the loop, its components, and what happens in it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <cca/graph/items/deployment.hpp>
#include <cca/graph/items/modes.hpp>
#include <cca/runtime/each_component.hpp>
#include <cca/runtime/observers/trace_event.hpp>

namespace cca::detail {

struct trace_names {
  struct call {
    std::string path;
    std::string_view phase;  // process, sense or act
  };
  std::string track;
  std::vector<call> calls;                     // by the number of the call; empty: there is none
  std::vector<std::string> components;         // by number
  std::vector<std::string_view> environments;  // of the deployment
  std::vector<std::string_view> modes;         // of the set
};

constexpr std::string_view name_of_phase(phase_of_beat phase) {
  switch (phase) {
    case phase_of_beat::sense:
      return "sense";
    case phase_of_beat::act:
      return "act";
    default:
      return "process";
  }
}

// The calls of a beat, after those of the modes before.
template <class Graph>
void add_calls(std::vector<trace_names::call>& to) {
  const std::size_t first = to.size();
  to.resize(first + 2 * array_size(counts_of<Graph>.node_count));
  for (int c = 0; c < counts_of<Graph>.call_count; ++c) {
    const auto& one = plan_of<Graph>.calls[array_size(c)];
    to[first + array_size(trace_name(one.node, one.phase))] = {path_of_node<Graph>(one.node),
                                                               name_of_phase(one.phase)};
  }
}

template <class Graph>
std::vector<std::string> paths_of_components() {
  std::vector<std::string> all;
  for (int n = 0; n < counts_of<Graph>.node_count; ++n) all.push_back(path_of_node<Graph>(n));
  return all;
}

}  // namespace cca::detail
