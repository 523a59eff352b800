// Listening to a scope: the samples of all outputs under it, as an array of observations.
#pragma once

#include <cca/base/inlining.hpp>
#include <cca/runtime/inputs.hpp>

namespace cca::detail {

constexpr bool has_observers(const call& t) {
  for (int p = 0; p < t.function->input_count; ++p)
    if (!t.function->inputs[p].space) return true;
  return false;
}

// Calls f.template operator()<Link>() for each link of the observers of a call, or of one of them.
template <class Graph, int Call, int OnlyInput, int Link, class F>
CCA_INLINE void if_observed(F& f) {
  constexpr int input = plan_of<Graph>.links[Link].input;
  if constexpr (input_of<Graph, input>.call == Call && (OnlyInput < 0 || OnlyInput == input)) {
    CCA_INLINE_CALL f.template operator()<Link>();
  }
}
template <class Graph, int Call, int OnlyInput, class F, int... Link>
CCA_INLINE void for_each_link([[maybe_unused]] F& f, std::integer_sequence<int, Link...>) {
  (if_observed<Graph, Call, OnlyInput, Link>(f), ...);
}
template <class Graph, int Call, int OnlyInput = -1, class F>
CCA_INLINE void for_each_observed(F f) {
  if constexpr (has_observers(call_of<Graph, Call>))
    for_each_link<Graph, Call, OnlyInput>(f, std::make_integer_sequence<int, counts_of<Graph>.link_count>{});
}

// What an observer hears of one output. What a wire gives as an initial value is its reader's alone: an
// observer sees the space's zero.
template <class Graph, int Link>
struct observed_output {
  static constexpr int output = plan_of<Graph>.links[Link].output;
  static constexpr const auto& in = input_of<Graph, plan_of<Graph>.links[Link].input>;
  static constexpr int delay = call_of<Graph, in.call>.function->inputs[in.port].observed_delay;
  static constexpr place at = layout_of<Graph>.outputs[output];

  CCA_INLINE static const auto* shown(const beat_context<Graph>& b) {
    const auto* sample = b.template at<at.array>(at.index).show(b.k, delay);
    return sample && sample->origin() != never ? sample : nullptr;
  }
  CCA_INLINE static std::int64_t arrived(const beat_context<Graph>& b) {
    return b.template at<at.array>(at.index).arrived(b.k, delay);
  }
  CCA_INLINE static std::int64_t origin(const beat_context<Graph>& b) {
    const auto* sample = shown(b);
    return sample ? sample->origin() : never;
  }
};

// The oldest origin, where observers listen too.
template <class Graph, int Call>
CCA_INLINE std::int64_t oldest_heard(const beat_context<Graph>& b, std::int64_t oldest) {
  for_each_observed<Graph, Call>([&]<int Link>() {
    if constexpr (plan_of<Graph>.links[Link].counts)
      oldest = older(oldest, observed_output<Graph, Link>::origin(b));
  });
  return oldest;
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

template <class Graph>
struct is_watched {
  static constexpr bool holds(std::size_t o) { return plan_of<Graph>.outputs[o].watched; }
};

// Calls f(observation) with the newest sample of an output, between two beats; k is the next.
template <class Graph, int Output, class F>
void observe_newest(const controller_state<Graph>& state, std::int64_t k, F& f) {
  constexpr place at = layout_of<Graph>.outputs[Output];
  const auto& stored = sample_in<Graph, at.array>(state, at.index);
  const auto* sample = stored.show(k - 1, 0);
  const double* values = sample ? sample->vector().data() : output_port_of<Graph, Output>.space->zero;
  f(observation{path_of_output<Graph, Output>(),
                {values, static_cast<std::size_t>(size_of_output<Graph, Output>)},
                sample ? sample->origin() : never,
                k > 0 && stored.arrived(k - 1, 0) == k - 1});
}

// All outputs that an `observe` among the items of a graph names.
template <class Graph, class F>
void observe_all(const controller_state<Graph>& state, std::int64_t k, F& f) {
  [&]<int... Output>(std::integer_sequence<int, Output...>) {
    const int all[] = {0, (observe_newest<Graph, Output>(state, k, f), 0)...};
    (void)all;
  }(chosen<counts_of<Graph>.output_count, is_watched<Graph>>{});
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
  CCA_INLINE observations(const beat_context<Graph>& b, std::int64_t last) {
    double* next = values.data();
    for_each_observed<Graph, input_of<Graph, Input>.call, Input>([&]<int Link>() {
      using from = observed_output<Graph, Link>;
      constexpr auto size = static_cast<std::size_t>(size_of_output<Graph, from::output>);
      const auto* sample = from::shown(b);
      for (std::size_t c = 0; c < size; ++c)
        next[c] = sample ? sample->vector()[static_cast<int>(c)]
                         : output_port_of<Graph, from::output>.space->zero[static_cast<int>(c)];
      entries[count++] = {path_of_output<Graph, from::output>(),
                          {next, size},
                          sample ? sample->origin() : never,
                          from::arrived(b) > last};
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

template <class Graph, fixed_string Scope, class Policy, int Input>
struct argument<Graph, observe<Scope, Policy>, Input> {
  template <class>
  CCA_INLINE static observations<Graph, Input> get(const beat_context<Graph>& b,
                                                   int,
                                                   beat,
                                                   std::int64_t last) {
    return {b, last};
  }
};

}  // namespace cca::detail
