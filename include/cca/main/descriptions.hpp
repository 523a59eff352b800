// The options by which a program describes what it would run, instead of running it:
//
//   --write-parameters FILE   all parameters as a run would begin with them, with units, ranges and choices;
//                             --config reads the file unchanged
//   --list                    all outputs, each with its space, units and rate
//
//   cca::offer_descriptions<cca::controller<trot>>(line, [&](auto& c) {
//     for (const std::string& file : configs) cca::read_parameters(c, file);
//   });
//
// The function gives a new controller the parameters of a run; it is called when the option is used. No
// component's hook runs. cca::robot_main has these options; a program with a main function of its own calls
// this. Errors: cca::refused for parameters that --config would refuse. Test:
// tests/runtime/programs/descriptions.cpp; docs/programs.md.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <cca/base/separate/compiled.hpp>
#include <cca/config/files.hpp>
#include <cca/main/command_line.hpp>
#include <cca/runtime/each_component.hpp>
#include <cca/space/info.hpp>

namespace cca {
namespace detail {

struct listed_output {
  std::string path;
  const space_info* space;
};
std::string list_of_outputs(const std::vector<listed_output>& all);

// `Graph`: a graph, a deployment or a set of modes.
template <class Graph>
std::string list_of_outputs() {
  std::vector<listed_output> all;
  for (int o = 0; o < counts_of<Graph>.output_count - counts_of<Graph>.taken_count; ++o)
    all.push_back({path_of_output<Graph>(o), &space_of_output<Graph>(o)});
  return list_of_outputs(all);
}

// `parameters(file)`: what --write-parameters writes; `outputs()`: what --list prints.
void offer_descriptions(command_line& line,
                        std::function<std::string(const std::string&)> parameters,
                        std::string (*outputs)());

template <class Controller>
struct graph_of_controller;
template <template <class> class Host, class Graph>
struct graph_of_controller<Host<Graph>> {
  using type = Graph;
};

}  // namespace detail

// Parameters from a file, and no more: as `load(file)` of a controller, without its hooks.
template <class Controller>
void read_parameters(Controller& c, const std::string& file) {
  detail::load_parameters(c, file);
}

template <class Controller>
void offer_descriptions(command_line& line, std::function<void(Controller&)> prepare = {}) {
  const auto parameters = [prepare = std::move(prepare)](const std::string& file) {
    const auto c = std::make_unique<Controller>();
    if (prepare) prepare(*c);
    return detail::parameters_text(*c, file);
  };
  detail::offer_descriptions(line, parameters,
                             detail::list_of_outputs<typename detail::graph_of_controller<Controller>::type>);
}

}  // namespace cca

#if !CCA_HAS_COMPILED_MAIN
#include <cca/main/descriptions_functions.hpp>
#endif
