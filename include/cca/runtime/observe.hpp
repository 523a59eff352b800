// Listening to a scope: the samples of all outputs under it, as an array of observations.
#pragma once

#include <cca/base/inlining.hpp>
#include <cca/runtime/read.hpp>

namespace cca::detail {

constexpr bool has_observers(const call& t) {
  for (int p = 0; p < t.function->input_count; ++p)
    if (!t.function->inputs[p].space) return true;
  return false;
}

// Calls f.template operator()<Link>() for each link of the observers of a function, or of one of them.
template <class Graph, int Call, int OnlyInput = -1, class F>
CCA_GLUE void for_each_observed(F f) {
  if constexpr (has_observers(call_of<Graph, Call>)) {
    CCA_INLINE_CALL[&]<int... L>(std::integer_sequence<int, L...>) {
      [[maybe_unused]] const auto one = [&]<int Link>(std::integral_constant<int, Link>) {
        constexpr int input = plan_of<Graph>.links[Link].input;
        if constexpr (input_of<Graph, input>.call == Call && (OnlyInput < 0 || OnlyInput == input))
          f.template operator()<Link>();
      };
      if constexpr (sizeof...(L) > 0) CCA_INLINE_CALL(one(std::integral_constant<int, L>{}), ...);
    }
    (std::make_integer_sequence<int, counts_of<Graph>.link_count>{});
  }
}

template <int Size>
struct held : coordinates<Size> {
  std::int64_t arrived;  // beat; -1: nothing has
};

template <class Graph, int Link>
CCA_GLUE auto observe_one(const memory<Graph>& m, std::int64_t k) {
  constexpr int output = plan_of<Graph>.links[Link].output;
  constexpr const auto& in = input_of<Graph, plan_of<Graph>.links[Link].input>;
  constexpr int delay = call_of<Graph, in.call>.function->inputs[in.port].observed_delay;
  constexpr int size = size_of_output<Graph, output>;
  held<size> h{{{}, never}, -1};
  if constexpr (delay > 0 && output_of<Graph, output>.ring > 0) {
    constexpr seat place = layout_of<Graph>.past[output];
    if (const auto* entry =
            arrived_entry<Graph, output, delay>(stored_at<Graph, place.group>(m, m, place.slot), k)) {
      copy_coordinates<size>(h.value, entry->value);
      h.origin = entry->origin;
      h.arrived = entry->when + delay;
    } else {
      copy_coordinates<size>(h.value, output_port_of<Graph, output>.space->zero);
    }
  } else {
    constexpr auto c = published_of<Graph, output>;
    constexpr seat place = layout_of<Graph>.newest[output];
    const auto& s = stored_at<Graph, place.group>(m, m, place.slot);
    // What a wire gives as initial value is its reader's alone.
    if (s.origin == never) copy_coordinates<size>(h.value, output_port_of<Graph, output>.space->zero);
    else copy_coordinates<size>(h.value, s.value);
    h.origin = s.origin;
    if constexpr (c.known()) h.arrived = newest_tick({c.period, c.first + delay}, k);
    else if constexpr (!c.never()) h.arrived = s.when < 0 ? -1 : s.when + delay;
  }
  return h;
}

struct written_path {
  char letters[256]{};
  std::size_t size = 0;
};

// The path of an output from the outermost graph, as static text.
template <class Graph, int Output>
inline constexpr auto output_path = [] {
  written_path path;
  std::array<std::string_view, 32> parts{};
  std::size_t count = 0;
  constexpr const auto& o = output_of<Graph, Output>;
  constexpr const auto& t = call_of<Graph, o.call>;
  constexpr const auto& node = plan_of<Graph>.nodes[t.node];
  const auto* scopes = plan_of<Graph>.scopes.data();
  parts[count++] = t.function->outputs[o.port].name;
  parts[count++] = node.item->from;
  for (int s = node.scope; scopes[s].item; s = scopes[s].parent) parts[count++] = scopes[s].item->from;
  while (count-- > 0) {
    for (const char c : parts[count]) path.letters[path.size++] = c;
    if (count > 0) path.letters[path.size++] = '.';
  }
  return path;
}();

template <class Graph, int Output>
constexpr std::string_view path_of_output() {
  return {output_path<Graph, Output>.letters, output_path<Graph, Output>.size};
}

// What one observer hears. The entries point into the values, so it is filled where it stays.
template <class Graph, int Input>
class observations {
  // Coordinates of all samples, and their number.
  static constexpr auto sizes = [] {
    std::pair<std::size_t, std::size_t> total{};
    const auto* outputs = plan_of<Graph>.outputs.data();
    const auto* calls = plan_of<Graph>.calls.data();
    const auto* link = plan_of<Graph>.links.data();
    for (int l = 0; l < counts_of<Graph>.link_count; ++l, ++link)
      if (link->input == Input) {
        const auto& o = outputs[link->output];
        total.first += static_cast<std::size_t>(calls[o.call].function->outputs[o.port].space->size);
        ++total.second;
      }
    return total;
  }();

public:
  CCA_GLUE observations(const memory<Graph>& m, std::int64_t k, std::int64_t last) {
    double* next = values.data();
    for_each_observed<Graph, input_of<Graph, Input>.call, Input>([&]<int Link>() {
      constexpr int output = plan_of<Graph>.links[Link].output;
      constexpr int size = size_of_output<Graph, output>;
      const auto h = observe_one<Graph, Link>(m, k);
      copy_coordinates<size>(next, h.value);
      entries[count++] = {path_of_output<Graph, output>(),
                          {next, static_cast<std::size_t>(size)},
                          h.origin,
                          h.arrived > last};
      next += size;
    });
  }
  observations(const observations&) = delete;
  observations& operator=(const observations&) = delete;

  template <fixed_string Scope, class Policy>
  operator observe<Scope, Policy>() const {
    return {entries.data(), count};
  }

private:
  std::array<observation, sizes.second + 1> entries;
  std::array<double, sizes.first + 1> values;
  std::size_t count = 0;
};

}  // namespace cca::detail
