// Observing: what a pattern names, as an array of observations. A component reads each of them by an input of
// its own (graph/planning/steps/listen.hpp), so each is stored, late and fresh as over a wire.
#pragma once

#include <algorithm>
#include <array>

#include <cca/base/inlining.hpp>
#include <cca/graph/plan/patterns.hpp>
#include <cca/runtime/inputs.hpp>

namespace cca::detail {

constexpr bool has_observers(const call& t) {
  for (int p = 0; p < t.function->input_count; ++p)
    if (!t.function->inputs[p].space) return true;
  return false;
}

// The links of an observer, or of all observers of a call: they stand side by side.
struct link_range {
  int first = 0, count = 0;
};
template <class Graph>
constexpr link_range links_where(auto is_wanted) {
  link_range range;
  for (int l = 0; l < counts_of<Graph>.link_count; ++l)
    if (is_wanted(plan_of<Graph>.links[static_cast<std::size_t>(l)].observer) && range.count++ == 0)
      range.first = l;
  return range;
}
template <class Graph, int Call>
inline constexpr link_range links_of_call = links_where<Graph>([](int i) {
  const input& own = plan_of<Graph>.inputs[static_cast<std::size_t>(i)];
  return own.call == Call && !own.outside;
});
template <class Graph, int Observer>
inline constexpr link_range links_of_observer = links_where<Graph>([](int i) { return i == Observer; });

// Calls f.template operator()<Link>() for each link of a range.
template <int Link, class F>
CCA_INLINE constexpr void call_for_link(F& f) {
  CCA_INLINE_CALL f.template operator()<Link>();
}
template <int First, class F, int... Number>
CCA_INLINE constexpr void for_some_links([[maybe_unused]] F& f, std::integer_sequence<int, Number...>) {
  (call_for_link<First + Number>(f), ...);
}
// In halves: docs/compilers.md.
template <int First, int Count, class F>
CCA_INLINE constexpr void for_each_link([[maybe_unused]] F& f) {
  if constexpr (Count > 128) {
    for_each_link<First, Count / 2>(f);
    for_each_link<First + Count / 2, Count - Count / 2>(f);
  } else {
    for_some_links<First>(f, std::make_integer_sequence<int, Count>{});
  }
}
template <class Graph, int Call, class F>
CCA_INLINE void for_each_observed(F f) {
  constexpr link_range range = links_of_call<Graph, Call>;
  for_each_link<range.first, range.count>(f);
}

// One link, as its observer reads it.
template <class Graph, int Link>
struct observed_sample {
  static constexpr int input = counts_of<Graph>.first_link + Link;
  using reader = input_reader<Graph, input>;
  static constexpr int index = layout_of<Graph>.sources[input].index;
  static constexpr const space_info& space = space_of_input<Graph, input>;

  CCA_INLINE static const double* values(const beat_context<Graph>& b) {
    const auto* sample = reader::shown(b, index);
    if constexpr (reader::is_never_null) return sample->vector().data();
    else return sample ? sample->vector().data() : initial_of_input<Graph, input>();
  }
  CCA_INLINE static std::int64_t origin(const beat_context<Graph>& b) { return reader::origin(b, index); }
  CCA_INLINE static bool is_fresh(const beat_context<Graph>& b, std::int64_t last) {
    return reader::is_fresh(b, index, last);
  }
};

// The oldest origin, where observers listen too.
template <class Graph, int Call>
CCA_INLINE std::int64_t oldest_heard(const beat_context<Graph>& b, std::int64_t oldest) {
  for_each_observed<Graph, Call>([&]<int Link>() {
    using from = observed_sample<Graph, Link>;
    if constexpr (from::reader::counts) {
      if constexpr (from::reader::in.counts_vary) {
        const auto* sample = from::reader::shown(b, from::index);
        if (sample && !from::reader::counts_here(*sample)) return;
      }
      oldest = older(oldest, from::origin(b));
    }
  });
  return oldest;
}

// After the component has seen them.
template <class Graph, int Call>
CCA_INLINE void take_heard(const beat_context<Graph>& b) {
  for_each_observed<Graph, Call>([&]<int Link>() {
    using from = observed_sample<Graph, Link>;
    if constexpr (is_queued(input_of<Graph, from::input>)) from::reader::take(b, from::index);
  });
}

struct written_path {
  char letters[256]{};
  std::size_t size = 0;

  constexpr std::string_view view() const { return {letters, size}; }
};

// A path as static text.
constexpr written_path written(const text& path) {
  written_path copy;
  for (; copy.size < path.size && copy.size < sizeof(copy.letters); ++copy.size)
    copy.letters[copy.size] = path.letters[copy.size];
  return copy;
}

// The path of a port from the outermost graph, by its own name or as a graph exposes it.
template <class Graph, class Port>
constexpr written_path path_of_port(const Port& port, ref<item_info> as) {
  const auto& plan = plan_of<Graph>;
  const flat_view g = plan.view();
  text path;
  add_path(path, path_from(g, name_as(g, port, as), 0));
  return written(path);
}
template <class Graph, int Link>
inline constexpr written_path path_of_link = [] {
  constexpr const link& heard = plan_of<Graph>.links[Link];
  if constexpr (heard.input < 0) return path_of_port<Graph>(output_of<Graph, heard.output>, heard.heard_as);
  else return path_of_port<Graph>(input_of<Graph, heard.input>, heard.heard_as);
}();
template <class Graph, int Scope>
inline constexpr written_path path_of_scope = [] {
  const auto& plan = plan_of<Graph>;
  text path;
  add_scope_path(path, plan.view(), Scope);
  if (path.size > 0) --path.size;  // a dot
  return written(path);
}();

// What one observer hears. It is filled where it stays: the observations point into it.
template <class Graph, int Observer>
class observations {
  static constexpr link_range range = links_of_observer<Graph, Observer>;
  static constexpr int scope =
      plan_of<Graph>.nodes[call_of<Graph, input_of<Graph, Observer>.call>.node].scope;

  // Where the room for the sample of each link begins.
  static constexpr auto rooms_at = [] {
    std::array<std::size_t, array_size(range.count + 1)> begins{};
    const auto add = [&]<int Link>() {
      constexpr std::size_t number = array_size(Link - range.first);
      begins[number + 1] = begins[number] + room_of_sample(observed_sample<Graph, Link>::space.size);
    };
    for_each_link<range.first, range.count>(add);
    return begins;
  }();

public:
  CCA_INLINE observations(const beat_context<Graph>& b, std::int64_t last) {
    const auto hear = [&]<int Link>() {
      using from = observed_sample<Graph, Link>;
      constexpr std::size_t number = array_size(Link - range.first);
      entries[number] = {path_of_link<Graph, Link>.view(),
                         {from::values(b), array_size(from::space.size)},
                         from::origin(b),
                         from::is_fresh(b, last),
                         &from::space,
                         rooms + rooms_at[number]};
    };
    for_each_link<range.first, range.count>(hear);
  }
  observations(const observations&) = delete;
  observations& operator=(const observations&) = delete;

  template <fixed_string Pattern, class... Policies>
  operator observe<Pattern, Policies...>() const {
    return {entries.data(), array_size(range.count), path_of_scope<Graph, scope>.view()};
  }

private:
  std::array<observation, array_size(range.count + 1)> entries;
  alignas(alignment_of_room) unsigned char rooms[rooms_at[array_size(range.count)] + 1];
};

template <class Graph, fixed_string Pattern, class... Policies, int Input>
struct argument<Graph, observe<Pattern, Policies...>, Input> {
  template <class, class = void>
  CCA_INLINE static observations<Graph, Input> get(const beat_context<Graph>& b,
                                                   int,
                                                   beat,
                                                   std::int64_t last) {
    return {b, last};
  }
};

// ---- outside of the graph, between two beats ----

template <class Graph>
struct is_watched {
  static constexpr bool holds(std::size_t o) { return plan_of<Graph>.outputs[o].watched; }
};
template <class Graph>
struct is_watched_newest {
  static constexpr bool holds(std::size_t o) { return plan_of<Graph>.outputs[o].watched_newest; }
};
template <class Graph>
struct is_watched_input {
  static constexpr bool holds(std::size_t i) { return plan_of<Graph>.inputs[i].watched; }
};

// Of each port and graph one text, whose address is its key (live/live_outputs.hpp).
template <class Graph, int Output>
inline constexpr written_path path_of_watched_output =
    path_of_port<Graph>(output_of<Graph, Output>, output_of<Graph, Output>.watched_as);
template <class Graph, int Input>
inline constexpr written_path path_of_watched_input =
    path_of_port<Graph>(input_of<Graph, Input>, input_of<Graph, Input>.watched_as);

// Calls f(observation) with the newest sample of an output; k is the next beat.
template <class Graph, int Output, class F>
void observe_newest(const controller_state<Graph>& state, std::int64_t k, F& f) {
  constexpr place at = layout_of<Graph>.outputs[Output];
  constexpr const space_info& space = *output_port_of<Graph, Output>.space;
  const auto& stored = sample_in<Graph, at.array>(state, at.index);
  const auto* sample = stored.show(k - 1, 0);
  if constexpr (output_of<Graph, Output>.initial_of)  // it shows that of a wire
    if (sample && sample->origin() == never) sample = nullptr;
  alignas(alignment_of_room) unsigned char room[room_of_sample(space.size)];
  f(observation{path_of_watched_output<Graph, Output>.view(),
                {sample ? sample->vector().data() : space.zero, array_size(space.size)},
                sample ? sample->origin() : never,
                k > 0 && stored.arrived(k - 1, 0) == k - 1,
                &space,
                room});
}

// The same with what an input shows.
template <class Graph, int Input, class F>
void observe_shown(const controller_state<Graph>& state, std::int64_t k, F& f) {
  constexpr place at = layout_of<Graph>.sources[Input];
  constexpr const auto& in = input_of<Graph, Input>;
  constexpr const space_info& space = space_of_input<Graph, Input>;
  const auto& stored = sample_in<Graph, at.array>(state, at.index);
  const auto* sample = stored.show(k - 1, in.delay);
  if (in.own_initial && sample && sample->origin() == never) sample = nullptr;
  alignas(alignment_of_room) unsigned char room[room_of_sample(space.size)];
  f(observation{path_of_watched_input<Graph, Input>.view(),
                {sample ? sample->vector().data() : initial_of_input<Graph, Input>(), array_size(space.size)},
                sample ? sample->origin() : never,
                k > 0 && stored.arrived(k - 1, in.delay) == k - 1,
                &space,
                room});
}

// What the program reads by a policy, as over a wire: a queue shows its oldest sample, or what was taken
// last.
template <class Graph>
struct is_read_outside {
  static constexpr bool holds(std::size_t l) {
    const auto& plan = plan_of<Graph>;
    const input& own = plan.inputs[array_size(plan.links[l].observer)];
    return own.outside && !plan.calls[array_size(own.call)].elsewhere;
  }
};
template <class Graph>
using links_outside =
    chosen<graph_size<Graph>.watches == 0 ? 0 : counts_of<Graph>.link_count, is_read_outside<Graph>>;

template <class Graph, int Link, class F>
void observe_link(const controller_state<Graph>& state, std::int64_t k, F& f) {
  constexpr int number = plan_of<Graph>.links[Link].observer;
  constexpr place at = layout_of<Graph>.sources[number];
  constexpr const auto& in = input_of<Graph, number>;
  constexpr const space_info& space = space_of_input<Graph, number>;
  const auto& stored = sample_in<Graph, at.array>(state, at.index);
  const auto* sample = stored.show(k - 1, in.delay);
  if (in.own_initial && sample && sample->origin() == never) sample = nullptr;
  bool is_fresh = k > 0 && stored.arrived(k - 1, in.delay) == k - 1;
  if constexpr (is_queued(in)) is_fresh = !stored.is_empty();
  alignas(alignment_of_room) unsigned char room[room_of_sample(space.size)];
  f(observation{
      path_of_link<Graph, Link>.view(),
      {sample ? sample->vector().data() : initial_of_input<Graph, number>(), array_size(space.size)},
      sample ? sample->origin() : never,
      is_fresh,
      &space,
      room});
}
template <class Graph, class F>
void observe_outside([[maybe_unused]] const controller_state<Graph>& state,
                     [[maybe_unused]] std::int64_t k,
                     [[maybe_unused]] F& f) {
  [&]<int... Link>(std::integer_sequence<int, Link...>) {
    const int all[] = {0, (observe_link<Graph, Link>(state, k, f), 0)...};
    (void)all;
  }(links_outside<Graph>{});
}
// The program has seen them: the next call shows the next ones.
template <class Graph, int Link>
void take_link([[maybe_unused]] controller_state<Graph>& state) {
  constexpr int number = plan_of<Graph>.links[Link].observer;
  constexpr place at = layout_of<Graph>.sources[number];
  if constexpr (is_queued(input_of<Graph, number>)) sample_in<Graph, at.array>(state, at.index).take();
}
template <class Graph>
void take_outside([[maybe_unused]] controller_state<Graph>& state) {
  [&]<int... Link>(std::integer_sequence<int, Link...>) {
    const int all[] = {0, (take_link<Graph, Link>(state), 0)...};
    (void)all;
  }(links_outside<Graph>{});
}

// All ports that an `observe` among the items of a graph names: each as its policy says, or only the newest
// samples.
template <class Graph, class Outputs = is_watched<Graph>, class F>
void observe_newest_of(const controller_state<Graph>& state, std::int64_t k, F& f) {
  [&]<int... Output>(std::integer_sequence<int, Output...>) {
    const int all[] = {0, (observe_newest<Graph, Output>(state, k, f), 0)...};
    (void)all;
  }(chosen<counts_of<Graph>.output_count, Outputs>{});
  [&]<int... Input>(std::integer_sequence<int, Input...>) {
    const int all[] = {0, (observe_shown<Graph, Input>(state, k, f), 0)...};
    (void)all;
  }(chosen<counts_of<Graph>.first_link, is_watched_input<Graph>>{});
}
template <class Graph, class F>
void observe_all(const controller_state<Graph>& state, std::int64_t k, F& f) {
  observe_newest_of<Graph, is_watched_newest<Graph>>(state, k, f);
  observe_outside<Graph>(state, k, f);
}

}  // namespace cca::detail
