// The switch from one mode to another, between two beats: what the next mode lacks is stopped, what the last
// one lacked is reset and started. All else stays where it is, so nothing is copied.
//
// Cost: for each component and sample that not all modes have a test, and what its hook does.
#pragma once

#include <algorithm>
#include <cstdint>

#include <cca/runtime/each_component.hpp>
#include <cca/runtime/modes/shared_state.hpp>
#include <cca/runtime/stoppable_parts.hpp>

namespace cca::detail {

template <class M, int I>
inline constexpr mode_view view_of_mode =
    shared_plan_of<M>.view_of(shown_plan<mode_key<M, I>>, shown_plan<M>);

// The modes that have a node of mode I.
template <class M, int I>
constexpr mode_set modes_with(int node) {
  return plan_of<M>.nodes[array_size(shared_nodes<M, I>[array_size(node)])].members;
}
// The modes that have an output. What is taken from a queue only those that observe it have.
template <class M, int I>
constexpr mode_set modes_with_output(int output) {
  const auto& plan = plan_of<mode_key<M, I>>;
  const auto& out = plan.outputs[array_size(output)];
  if (out.is_taken) return plan_of<M>.outputs[array_size(view_of_mode<M, I>.shared_output(output))].members;
  return modes_with<M, I>(plan.calls[array_size(out.call)].node);
}
// May a component of a graph ask for a mode?
template <class Graph>
inline constexpr bool may_request = [] {
  for (std::size_t c = 0; c < array_size(counts_of<Graph>.call_count); ++c)
    if (plan_of<Graph>.calls[c].function->requested_count > 0) return true;
  return false;
}();

template <class M>
inline constexpr mode_set every_mode = all_of_modes(modes_of<M>::value);

// What a switch looks at in mode I: functions whose clock was another one before, and what other modes lack:
// last firings, outputs, queues.
template <class M, int I>
struct unsteady_call {
  static constexpr bool holds(std::size_t c) { return plan_of<mode_key<M, I>>.calls[c].unsteady; }
};
template <class M, int I>
struct kept_firing {
  static constexpr bool holds(std::size_t c) {
    return layout_of<mode_key<M, I>>.calls[c].firing >= 0 &&
           modes_with<M, I>(plan_of<mode_key<M, I>>.calls[c].node) != every_mode<M>;
  }
};
template <class M, int I>
struct passing_output {
  static constexpr bool holds(std::size_t o) {
    return plan_of<M>.outputs[array_size(view_of_mode<M, I>.shared_output(static_cast<int>(o)))].storage !=
               storage_kind::none &&
           modes_with_output<M, I>(static_cast<int>(o)) != every_mode<M>;
  }
};
// The same that another environment reads.
template <class M, int I>
struct passing_to_others {
  static constexpr bool holds(std::size_t o) {
    const auto& plan = plan_of<mode_key<M, I>>;
    return plan.outputs[o].leaves && !plan.calls[array_size(plan.outputs[o].call)].elsewhere &&
           modes_with_output<M, I>(static_cast<int>(o)) != every_mode<M>;
  }
};
template <class M, int I>
struct kept_for_queues {
  std::array<int, array_size(input_count_of<mode_key<M, I>> + 1)> queues{}, ways{};
};
template <class M, int I>
inline constexpr auto queues_of_mode = [] {
  kept_for_queues<M, I> numbers;
  numbers.queues.fill(-1);
  numbers.ways.fill(-1);
  for (std::size_t i = 0; i < array_size(counts_of<mode_key<M, I>>.input_count); ++i) {
    const input& in = plan_of<mode_key<M, I>>.inputs[i];
    const int number = static_cast<int>(i);
    if (is_queued(in) && in.way_of < 0)
      numbers.queues[i] = sharing::find_queue(view_of_mode<M, I>, number, shown_plan<M>);
    if (is_kept_way(shown_plan<mode_key<M, I>>, in))
      numbers.ways[i] = sharing::find_way(view_of_mode<M, I>, number, shown_plan<M>);
  }
  return numbers;
}();
template <class M>
constexpr bool is_passing(int queue) {
  if (queue < 0) return false;
  const input& in = plan_of<M>.inputs[array_size(queue)];
  return in.members != every_mode<M> && !plan_of<M>.calls[array_size(in.call)].elsewhere;
}
template <class M, int I>
struct passing_queue {
  static constexpr bool holds(std::size_t i) { return is_passing<M>(queues_of_mode<M, I>.queues[i]); }
};
template <class M, int I>
struct passing_way {
  static constexpr bool holds(std::size_t i) { return is_passing<M>(queues_of_mode<M, I>.ways[i]); }
};

template <class M, int I>
struct mode_switch {
  using part = mode_key<M, I>;
  static constexpr const auto& counts = counts_of<part>;
  state_of_modes<M>& state;

  // ---- from mode I to the next ----

  void leave(int next, std::int64_t k, bool is_started) {
    if (is_started)
      for_each<counts.node_count, hook<false>>([&]<int Node>() {
        if (!has_mode(modes_with<M, I>(Node), next) && !rests(Node)) component<Node>().on_stop();
      });
    // From here on the clock of this mode does not tell when they fired last.
    for_each<counts.call_count, unsteady_call<M, I>>([&]<int Call>() {
      if (rests(call_of<part, Call>.node)) return;  // when it starts again nothing that was counts
      if (auto last = newest_tick(call_of<part, Call>.own_clock, k - 1);
          last >= 0 && last >= known_since<Call>(state)) {
        if constexpr (call_of<part, Call>.may_miss)
          last = last_fired(state, layout_of<part>.calls[Call].missed, last);
        if (last < 0) return;
        last_firing& kept = last_firing_of<Call>(state);
        kept.last = last;
        kept.is_first = false;
      }
    });
    for_each<counts.call_count, kept_firing<M, I>>([&]<int Call>() {
      if (!has_mode(modes_with<M, I>(call_of<part, Call>.node), next)) last_firing_of<Call>(state) = {};
    });
    for_each<counts.call_count, keeps_strategy<part>>([&]<int Call>() {
      if (!has_mode(modes_with<M, I>(call_of<part, Call>.node), next)) strategy_in<part, Call>(state) = {};
    });
    if constexpr (parts_kept<M> > 0)
      for (int p = 0; p < parts_kept<M>; ++p)
        if (!has_mode(plan_of<M>.parts[array_size(p)].members, next)) state.parts[array_size(p)] = {};
  }

  // ---- from the last mode to I ----

  // `k`: as this loop counts beats; `beat`: as the others do (a free-running environment counts cycles).
  void enter(int last, [[maybe_unused]] std::int64_t k, [[maybe_unused]] std::int64_t beat, bool is_started) {
    if constexpr (parts_kept<M> > 0)
      for (int p = 0; p < parts_kept<M>; ++p)
        if (!has_mode(plan_of<M>.parts[array_size(p)].members, last)) come(p, k);
    for_each<counts.output_count, passing_output<M, I>>([&]<int Output>() {
      if (!has_mode(modes_with_output<M, I>(Output), last)) begin_anew<Output>(beat);
    });
    for_each<counts.output_count, passing_to_others<M, I>>([&]<int Output>() {
      if (!has_mode(modes_with_output<M, I>(Output), last)) note_coming<Output>(state, beat);
    });
    for_each<counts.input_count, passing_queue<M, I>>([&]<int Input>() {
      constexpr int queue = queues_of_mode<M, I>.queues[array_size(Input)];
      if (!has_mode(plan_of<M>.inputs[array_size(queue)].members, last)) {
        constexpr place at = layout_of<M>.sources[queue];
        sample_in<M, at.array>(state, at.index).forget();
      }
    });
    for_each<counts.input_count, passing_way<M, I>>([&]<int Way>() {
      constexpr int way = queues_of_mode<M, I>.ways[array_size(Way)];
      if (!has_mode(plan_of<M>.inputs[array_size(way)].members, last)) { forget_way<way>(state, beat); }
    });
    if (is_started)
      for_each<counts.node_count, hook<true>>([&]<int Node>() {
        if (!has_mode(modes_with<M, I>(Node), last) && !rests(Node)) component<Node>().on_start();
      });
  }

private:
  // From another environment nothing more comes of what was published before. (Templates on the state: only
  // that of an environment knows of others.)
  template <int Way, class State>
  static void forget_way(State& in, [[maybe_unused]] std::int64_t beat) {
    constexpr place at = layout_of<M>.on_the_way[Way];
    if constexpr (at.array >= 0) sample_in<M, at.array>(in, at.index).forget();
    else in.template forget_way<Way>(beat);
  }
  template <int Output, class State>
  static void note_coming(State& in, std::int64_t beat) {
    in.template note_coming<view_of_mode<M, I>.shared_output(Output)>(beat);
  }
  template <int Output, class State>
  static void forget_arriving([[maybe_unused]] State& in, [[maybe_unused]] std::int64_t beat) {
    if constexpr (array_of<M, layout_of<M>.outputs[Output].array>.kind == storage_kind::arriving)
      in.template forget_output<Output>(beat);
  }

  // A template on the state: a set of modes whose clocks are all known keeps none.
  template <int Call, class State>
  static last_firing& last_firing_of(State& in) {
    return in.firings[layout_of<part>.calls[Call].firing];
  }

  // Components of this mode, but not of all modes, that have on_start, or on_stop.
  template <bool Starts>
  struct hook {
    static constexpr auto nodes = []<int... Node>(std::integer_sequence<int, Node...>) {
      return std::array<bool, sizeof...(Node) + 1>{
          (Starts ? OnStart<typename node_types<part, Node>::component>
                  : OnStop<typename node_types<part, Node>::component>)...,
          false};
    }(std::make_integer_sequence<int, counts.node_count>{});
    static constexpr bool holds(std::size_t node) {
      const auto& own = plan_of<part>.nodes[node];
      return nodes[node] && !plan_of<part>.calls[array_size(own.first_call)].elsewhere &&
             modes_with<M, I>(static_cast<int>(node)) != every_mode<M>;
    }
  };

  // Since when its clock tells when it fired.
  template <int Call, class State>
  static std::int64_t known_since(const State& state) {
    constexpr int in_part = part_of_call_at<part, Call>;
    if constexpr (in_part >= 0) return std::max(state.since, state.parts[array_size(in_part)].since);
    else return state.since;
  }

  template <int Count, class Predicate, class F>
  static void for_each(F f) {
    [&]<int... Number>(std::integer_sequence<int, Number...>) {
      const int all[] = { 0, (f.template operator()<Number>(), 0)... };
      (void)all;
    }(chosen<Count, Predicate>{});
  }

  template <int Node>
  auto& component() {
    return component_at<M, shared_nodes<M, I>[array_size(Node)]>(state);
  }

  // Then its hook has run, or it has stopped itself.
  bool rests([[maybe_unused]] int node) const {
    if constexpr (parts_kept<M> > 0) {
      const int in_part = plan_of<part>.nodes[array_size(node)].part;
      return in_part >= 0 && state.parts[array_size(in_part)].rests;
    }
    return false;
  }
  // A part that the last mode lacked is started; it rests if one around it does.
  void come(int p, std::int64_t k) {
    const int around = plan_of<M>.parts[array_size(p)].parent;
    state.parts[array_size(p)] = {};
    state.parts[array_size(p)].rests = around >= 0 && state.parts[array_size(around)].rests;
    state.parts[array_size(p)].since = k;
  }

  // It has not been published yet: it shows the initial value.
  template <int Output>
  void begin_anew([[maybe_unused]] std::int64_t beat) {
    constexpr int shared = view_of_mode<M, I>.shared_output(Output);
    constexpr place at = layout_of<M>.outputs[shared];
    auto& sample = sample_in<M, at.array>(state, at.index);
    sample.forget();
    if constexpr (array_of<M, at.array>.kind == storage_kind::newest ||
                  array_of<M, at.array>.kind == storage_kind::past)
      for (int c = 0; c < size_of_output<M, shared>; ++c)
        sample.begin_with(
            c, initial_coordinate(output_of<M, shared>.initial_of, *output_port_of<M, shared>.space, c));
    forget_arriving<shared>(state, beat);
  }
};

}  // namespace cca::detail
