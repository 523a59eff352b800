// The part of the model that the terminal shows: a page, its selection, and the text that is being typed.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "model.hpp"

namespace cca_door {

enum class page { components, parameters, log, environments, commands };
inline constexpr std::array<std::string_view, 5> page_names{"components", "parameters", "log", "environments",
                                                            "commands"};

// A line of the page of components: an output, or a component that has none.
struct component_row {
  std::string path{}, node{};
  const watched_output* output = nullptr;
};

struct top_view {
  enum class typing { nothing, value, filter, arguments, file };
  struct place {
    std::size_t chosen = 0, first = 0;  // of the rows: the chosen one, and the one at the top
  };

  page at = page::components;
  std::array<place, page_names.size()> places{};
  std::string filter{};
  typing types = typing::nothing;
  std::string typed{}, typed_for{};            // for which parameter or command
  std::map<std::string, std::string> given{};  // the last arguments of a command
  std::string file = "run.mcap";               // of the last recording
  std::size_t cursor = 0;
  std::size_t rows_shown = 1;         // by the last drawing
  std::set<std::string> looked_at{};  // outputs whose row was shown

  place& here() { return places[static_cast<std::size_t>(at)]; }
  const place& here() const { return places[static_cast<std::size_t>(at)]; }

  bool fits_filter(const std::string& path) const { return filter.empty() || path.find(filter) != path.npos; }

  std::vector<component_row> components(const top_model& of) const {
    std::vector<component_row> all;
    std::set<std::string> nodes;
    for (const watched_output& one : of.outputs) {
      nodes.insert(one.node);
      if (fits_filter(one.path)) all.push_back({one.path, one.node, &one});
    }
    for (const std::string& node : texts_in(of.description, "nodes"))
      if (!nodes.contains(node) && fits_filter(node)) all.push_back({node, node, nullptr});
    return all;
  }
  std::vector<const parameter*> parameters(const top_model& of) const {
    std::vector<const parameter*> all;
    for (const parameter& one : of.parameters)
      if (fits_filter(one.path)) all.push_back(&one);
    return all;
  }
  std::vector<const command*> commands(const top_model& of) const {
    std::vector<const command*> all;
    for (const command& one : of.commands)
      if (fits_filter(one.name)) all.push_back(&one);
    return all;
  }
  std::size_t row_count(const top_model& of) const {
    switch (at) {
      case page::components:
        return components(of).size();
      case page::parameters:
        return parameters(of).size();
      case page::log:
        return of.log.size();
      case page::environments:
        return list_in(of.status, "environments").size();
      case page::commands:
        return commands(of).size();
    }
    return 0;
  }
  const parameter* chosen_parameter(const top_model& of) const {
    const auto all = parameters(of);
    return at == page::parameters && here().chosen < all.size() ? all[here().chosen] : nullptr;
  }
  const command* chosen_command(const top_model& of) const {
    const auto all = commands(of);
    return at == page::commands && here().chosen < all.size() ? all[here().chosen] : nullptr;
  }

  // The chosen row stays on the screen, whatever rows come and go.
  void keep_in_view(std::size_t count, std::size_t rows) {
    place& p = here();
    rows_shown = std::max<std::size_t>(rows, 1);
    p.chosen = std::min(p.chosen, count > 0 ? count - 1 : 0);
    if (p.chosen < p.first) p.first = p.chosen;
    if (p.chosen >= p.first + rows_shown) p.first = p.chosen + 1 - rows_shown;
    if (p.first + rows_shown > count) p.first = count > rows_shown ? count - rows_shown : 0;
  }
  void move(std::ptrdiff_t by, std::size_t count) {
    place& p = here();
    const auto most = static_cast<std::ptrdiff_t>(count > 0 ? count - 1 : 0);
    p.chosen = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(p.chosen) + by, 0, most));
  }
};

}  // namespace cca_door
