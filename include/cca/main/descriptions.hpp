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

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <cca/base/file.hpp>
#include <cca/config/files.hpp>
#include <cca/main/command_line.hpp>
#include <cca/runtime/each_component.hpp>
#include <cca/space/space_schema.hpp>

namespace cca {
namespace detail {

// "rad", or one unit for each number: "m m m 1 1 1 1".
inline std::string units_text(const space_info& space) {
  const space_schema all(space);
  std::string units, first;
  bool is_same = true;
  for (int i = 0; i < all.field_count(); ++i) {
    const schema_field f = all.field(i);
    const std::string unit(f.unit.empty() ? "1" : f.unit);
    if (i == 0) first = unit;
    is_same = is_same && unit == first;
    units.append(i ? " " : "").append(unit);
  }
  return is_same ? first : units;
}

inline std::string rate_text(const space_info& space) {
  std::ostringstream text;
  if (space.hz > 0) text << space.hz << " Hz";
  else text << '-';
  return text.str();
}

// Columns. An entry of more than 40 letters is not aligned with.
inline std::string in_columns(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> width;
  for (const auto& row : rows) {
    width.resize(std::max(width.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i)
      if (row[i].size() <= 40) width[i] = std::max(width[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line.append(std::max(width[i], row[i].size()) + 2 - row[i].size(), ' ');
    }
    text += line + '\n';
  }
  return text;
}

// `Graph`: a graph, a deployment or a set of modes.
template <class Graph>
std::string list_of_outputs() {
  std::vector<std::vector<std::string>> rows{{"output", "space", "unit", "rate", "numbers"}};
  for (int o = 0; o < counts_of<Graph>.output_count - counts_of<Graph>.taken_count; ++o) {
    const space_info& space = space_of_output<Graph>(o);
    const space_schema all(space);
    std::string numbers;
    for (int i = 0; i < all.field_count(); ++i) numbers.append(i ? " " : "").append(all.field(i).name());
    rows.push_back(
        {path_of_output<Graph>(o), std::string(space.name), units_text(space), rate_text(space), numbers});
  }
  return in_columns(rows);
}

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
  using graph = typename detail::graph_of_controller<Controller>::type;
  line.instead(
      "--write-parameters FILE",
      [prepare = std::move(prepare)](const std::string& file) {
        if (file.empty()) throw command_line_error("--write-parameters: expected the name of a file");
        const auto c = std::make_unique<Controller>();
        if (prepare) prepare(*c);
        detail::write_file(file,
                           "# All parameters, as a run begins with them. --config reads this file.\n\n" +
                               detail::parameters_text(*c, file));
        return 0;
      },
      "writes all parameters, with units and ranges, for --config; nothing runs");
  line.instead(
      "--list",
      [](const std::string&) {
        std::cout << detail::list_of_outputs<graph>();
        return 0;
      },
      "prints all outputs, with space, unit and rate; nothing runs");
}

}  // namespace cca
