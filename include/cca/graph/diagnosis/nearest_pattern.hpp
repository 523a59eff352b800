// "Did you mean ...": the pattern nearest to one that names nothing.
#pragma once

#include <cca/base/nearest.hpp>
#include <cca/base/text.hpp>
#include <cca/graph/plan/patterns.hpp>

namespace cca::detail {

struct pattern_repair {
  const flat_view& g;
  std::string_view wrong;
  int scope, observer;
  names_of_ports names{g};
  text best{};
  std::size_t least = 0;

  constexpr bool names_something(const text& candidate) const {
    return for_each_named(g, names, candidate.view(), scope, observer, [](int, int, ref<item_info>) {}) > 0;
  }
  constexpr void try_with(std::size_t begin, std::size_t end, std::string_view name, std::size_t distance) {
    text candidate;
    candidate << wrong.substr(0, begin) << name << wrong.substr(end);
    if (!names_something(candidate)) return;
    best = candidate;
    least = distance;
  }
  constexpr void try_name(std::size_t begin, std::size_t end, std::string_view name) {
    const auto word = wrong.substr(begin, end - begin);
    const auto size = name.size();
    if ((size < word.size() ? word.size() - size : size - word.size()) >= least) return;
    if (const auto distance = edit_distance(word, name); distance > 0 && distance < least)
      try_with(begin, end, name, distance);
  }

  // One of its names replaced by another one that occurs in the graphs.
  constexpr void replace_word(std::size_t begin, std::size_t end) {
    least = (end - begin) / 3 + 2;
    for (int s = 0; s < g.scope_count; ++s)
      for (int i = 0; i < g.scopes[s].graph->count; ++i) {
        const auto& item = g.scopes[s].graph->items[i];
        if (item.kind == item_kind::node || item.kind == item_kind::graph) try_name(begin, end, item.from);
        if (item.kind == item_kind::expose) try_name(begin, end, item.to);
      }
    for (int o = 0; o < g.output_count - g.taken_count; ++o)
      try_name(begin, end, port_of(g, g.outputs[o]).name);
  }

  constexpr void run() {
    // A component or a graph, or its scope, stands for all that is under it.
    const bool is_scope = wrong.ends_with(".*") || wrong == "*";
    text below;
    below << wrong << (is_scope ? "*" : ".**");
    if (!wrong.ends_with("**") && names_something(below)) {
      best = below;
      return;
    }
    for (std::size_t begin = 0; begin < wrong.size() && best.size == 0;) {
      std::size_t end = begin;
      while (end < wrong.size() && wrong[end] != '.' && wrong[end] != '|' && wrong[end] != '/') ++end;
      const auto word = wrong.substr(begin, end - begin);
      if (!word.empty() && word != "*" && word != "**") replace_word(begin, end);
      begin = end + 1;
    }
  }
};

// Empty if none is near.
constexpr text nearest_pattern(const flat_view& g, std::string_view wrong, int scope, int observer) {
  pattern_repair repair{g, wrong, scope, observer};
  repair.run();
  return repair.best;
}

}  // namespace cca::detail
