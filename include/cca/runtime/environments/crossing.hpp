// What goes from one environment to another: outputs that are read there, with their delays.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <cca/graph/plan/deployment/part.hpp>
#include <cca/runtime/stoppable_parts.hpp>
#include <cca/runtime/state.hpp>

namespace cca::detail {

template <class D, int E>
inline constexpr bool runs_in_cycles<part<D, E>> = is_free_running<D, E>;
template <class Graph>
inline constexpr bool runs_in_cycles<probed<Graph>> = runs_in_cycles<Graph>;

// Whether an environment has a node of a part, and whether its components stop or start one.
template <class D, int E>
constexpr bool has_part(int number) {
  for (int n = 0; n < counts_of<D>.node_count; ++n)
    if (plan_of<D>.nodes[array_size(n)].environment == E && is_in_part<D>(n, number)) return true;
  return false;
}
template <class D>
constexpr bool asks_for_part(int environment, int number) {
  for (int r = 0; r < counts_of<D>.request_count; ++r) {
    const auto& request = plan_of<D>.requests[array_size(r)];
    const int node = plan_of<D>.calls[array_size(request.call)].node;
    if (request.part == number && plan_of<D>.nodes[array_size(node)].environment == environment) return true;
  }
  return false;
}
template <class D>
constexpr bool asks_for_parts(int environment) {
  for (int p = 0; p < counts_of<D>.part_count; ++p)
    if (asks_for_part<D>(environment, p)) return true;
  return false;
}
// What components of one environment ask for, of parts in another: it takes a beat, like a sample.
template <class D, int To>
constexpr bool is_asked_by(int from) {
  for (int p = 0; p < counts_of<D>.part_count; ++p)
    if (has_part<D, To>(p) && asks_for_part<D>(from, p)) return true;
  return false;
}

// These requests leave as samples do, after the outputs: number `output_count + E` has those of environment
// E. A coordinate for each part: its call's place in the order of a beat, from 1; below 0: to stop; 0:
// nothing.
template <class D>
constexpr bool is_request(int leaving) {
  return leaving >= counts_of<D>.output_count;
}
template <class D, int Leaving>
inline constexpr int size_of_leaving = [] {
  if constexpr (is_request<D>(Leaving)) return counts_of<D>.part_count;
  else return size_of_output<D, Leaving>;
}();

template <class D>
struct crossings {
  // For each output, the largest delay of a reader in another environment; 0: all readers are here. A wire of
  // a free-running environment may have none: it counts as one beat, because before a beat begins nothing
  // later is needed.
  std::array<int, array_size(graph_size<D>.outputs) + 1> largest_delay{};
  // From an environment to another the least delay; 0: nothing goes there.
  std::array<std::array<int, array_size(environment_count<D>)>, array_size(environment_count<D>)>
      least_delay{};
};

template <class D>
inline constexpr auto crossings_of = [] {
  crossings<D> found;
  auto plan = plan_of<D>;
  const flat_view g = plan.view();
  for (int o = 0; o < g.output_count; ++o) {
    const int from = environment_of(g, g.outputs[o].call);
    for_each_reader(g, o, [&](int to, int stated) {
      if (to == from) return;
      const int delay = stated > 0 ? stated : 1;
      int& largest = found.largest_delay[array_size(o)];
      int& least = found.least_delay[array_size(from)][array_size(to)];
      if (delay > largest) largest = delay;
      if (least == 0 || delay < least) least = delay;
    });
  }
  [&]<int... To>(std::integer_sequence<int, To...>) {
    for (int from = 0; from < environment_count<D>; ++from)
      ((is_asked_by<D, To>(from) && To != from ? void(found.least_delay[array_size(from)][To] = 1) : void()),
       ...);
  }(std::make_integer_sequence<int, environment_count<D>>{});
  return found;
}();

// Does another environment read it in the beat in which it is published?
constexpr bool is_read_at_once(const flat_view& g, int output) {
  bool is_read = false;
  const int from = environment_of(g, g.outputs[output].call);
  for_each_reader(g, output, [&](int to, int delay) { is_read |= to != from && delay == 0; });
  return is_read;
}
// Does a call read it in that beat?
constexpr bool reads_at_once(const flat_view& g, int call, int output) {
  for (int i = g.outputs[output].first_reader; i >= 0; i = g.inputs[i].next_of_writer)
    if (g.inputs[i].call == call && g.inputs[i].delay == 0) return true;
  return false;
}
constexpr bool is_call_read_at_once(const flat_view& g, int call) {
  const auto& c = g.calls[call];
  for (int o = c.first_output; o < c.first_output + c.function->output_count; ++o)
    if (is_read_at_once(g, o)) return true;
  return false;
}

template <class D>
struct leaves_environment {
  static constexpr bool holds(std::size_t o) {
    const int number = static_cast<int>(o);
    return is_request<D>(number) ? asks_for_parts<D>(number - counts_of<D>.output_count)
                                 : crossings_of<D>.largest_delay[o] > 0;
  }
};
// Outputs and requests.
template <class D>
using all_that_leaves = chosen<counts_of<D>.output_count + environment_count<D>, leaves_environment<D>>;
template <class D, int Leaving>
inline constexpr int largest_delay_of = [] {
  if constexpr (is_request<D>(Leaving)) return 1;
  else return crossings_of<D>.largest_delay[Leaving];
}();

template <class D, int E>
struct leaves_by_clock {
  static constexpr bool holds(std::size_t o) {
    auto plan = plan_of<D>;
    return crossings_of<D>.largest_delay[o] > 0 && environment_of(plan.view(), plan.outputs[o].call) == E &&
           published(plan.view(), plan.outputs[o]).known();
  }
};

// Whoever has all samples of an environment's outputs up to a beat knows that it has done the beat: they are
// published by known clocks, and it can't fault after them. `Output`: those whose samples are seen. Where
// one is read at once its reader looks at the position.
template <class D, int E, int... Output>
inline constexpr bool samples_tell = [] {
  auto plan = plan_of<D>;
  const flat_view g = plan.view();
  return !counts_of<part<D, E>>.may_fault && !asks_for_parts<D>(E) &&
         ((is_request<D>(Output) || environment_of(g, g.outputs[Output].call) != E ||
           (published(g, g.outputs[Output]).known() && !is_read_at_once(g, Output))) &&
          ...);
}();

template <class D, int Output>
inline constexpr bool is_of_free_running = [] {
  if constexpr (is_request<D>(Output)) return false;
  auto plan = plan_of<D>;
  return environments_of<D>::all[array_size(environment_of(plan.view(), plan.outputs[Output].call))]
      .is_free_running;
}();
template <class D>
struct runs_freely {
  static constexpr bool holds(std::size_t e) { return environments_of<D>::all[e].is_free_running; }
};
template <class D>
using free_environments = chosen<environment_count<D>, runs_freely<D>>;

// The outputs of others of which an environment stores the newest samples.
template <class Part>
struct arrives {
  static constexpr bool holds(std::size_t o) {
    return plan_of<Part>.outputs[o].storage == storage_kind::arriving;
  }
};
// The ways from outputs of others into its queues.
template <class Part>
struct enters {
  static constexpr bool holds(std::size_t way) {
    const auto& plan = plan_of<Part>;
    const input& in = plan.inputs[way];
    return is_queued(in) && !plan.calls[array_size(in.call)].elsewhere &&
           plan.calls[array_size(plan.outputs[array_size(in.writer)].call)].elsewhere;
  }
};
template <class Part>
using ways_from_elsewhere =
    chosen<counts_of<Part>.queue_count == 0 ? 0 : counts_of<Part>.input_count, enters<Part>>;

// The outputs that an environment reads from others.
template <class Part>
struct comes {
  static constexpr bool holds(std::size_t o) {
    if (arrives<Part>::holds(o)) return true;
    const auto& plan = plan_of<Part>;
    for (int i = plan.outputs[o].first_reader; i >= 0; i = plan.inputs[array_size(i)].next_of_writer)
      if (enters<Part>::holds(array_size(i))) return true;
    return false;
  }
};

// Input number `i` has a queue that may reject what arrives when a beat begins.
template <class Plan>
constexpr bool may_reject_entries(const Plan& plan, int i) {
  if (plan.inputs[array_size(i)].way_of >= 0) return false;
  for (int way = i; way >= 0; way = plan.inputs[array_size(way)].next_way)
    if (may_fault_at_begin(plan.inputs[array_size(way)])) return true;
  return false;
}

// The most samples that wait at a queue in another environment; 0: none does.
template <class D, int Output>
inline constexpr int most_waiting = [] {
  if (is_request<D>(Output)) return 0;
  auto plan = plan_of<D>;
  const flat_view g = plan.view();
  int most = 0;
  for (int i = g.outputs[Output].first_reader; i >= 0; i = g.inputs[i].next_of_writer)
    if (const auto& in = g.inputs[i];
        in.queue >= 0 && environment_of(g, in.call) != environment_of(g, g.outputs[Output].call))
      most = std::max(most, in.wire->capacity);
  return most;
}();

// The ways from one environment to another into a queue that keeps what came first.
template <class D>
struct keeps_first {
  static constexpr bool holds(std::size_t i) {
    auto plan = plan_of<D>;
    const flat_view g = plan.view();
    const input& in = g.inputs[i];
    return is_queued(in) && in.wire->full == full_kind::drop_newest &&
           environment_of(g, in.call) != environment_of(g, g.outputs[in.writer].call);
  }
};
template <class D>
using ways_that_keep = chosen<counts_of<D>.queue_count == 0 ? 0 : counts_of<D>.input_count, keeps_first<D>>;

// Of a free-running environment: queues elsewhere take all samples that its cycles publish.
template <class D, int Output>
inline constexpr bool is_gathered = is_of_free_running<D, Output> && most_waiting<D, Output> > 0;

// How many of them one beat may have at most; 0: queues do not take them all.
template <class D>
inline constexpr auto gathered_in_a_beat = []<int... Output>(std::integer_sequence<int, Output...>) {
  return std::array<int, sizeof...(Output) + 1>{
      (is_gathered<D, Output> ? 2 * most_waiting<D, Output> : 0)...};
}(std::make_integer_sequence<int, counts_of<D>.output_count>{});

template <class D>
struct leaves_gathered {
  static constexpr bool holds(std::size_t o) { return gathered_in_a_beat<D>[o] > 0; }
};

// How many beats an environment may be ahead of those that read from it, and of the first one, in a fast
// run. More than that smooths nothing: the samples of a ring stay in the caches while it is short.
template <class D>
inline constexpr std::int64_t most_ahead = 4 + std::min(std::ranges::max(crossings_of<D>.largest_delay), 16);

// The samples that an environment waits for before a beat prove that their writer is at most `most_ahead`
// beats behind. So the environment need not read the writer's position.
template <class D, int From, int To>
inline constexpr bool samples_show_progress = [] {
  return []<int... Output>(std::integer_sequence<int, Output...>) {
    auto plan = plan_of<D>;
    const flat_view g = plan.view();
    const int delay = crossings_of<D>.least_delay[From][To];
    [[maybe_unused]] const auto shows = [&](const output& from) {
      const clock ticks = published(g, from);
      return environment_of(g, from.call) == From && ticks.known() &&
             ticks.first + delay <= most_ahead<D> + 1 && ticks.period - 1 + delay <= most_ahead<D>;
    };
    return samples_tell<D, From, Output...> && (shows(plan.outputs[Output]) || ...);
  }(chosen<counts_of<D>.output_count, comes<part<D, To>>>{});
}();

// Those that write to an environment, and all if it is the first, see from its samples how far it is.
template <class D, int From>
inline constexpr bool samples_show_progress_to_all = []<int... To>(std::integer_sequence<int, To...>) {
  return ((To == From || (crossings_of<D>.least_delay[To][From] == 0 && From != 0) ||
           samples_show_progress<D, From, To>) &&
          ...);
}(std::make_integer_sequence<int, environment_count<D>>{});

}  // namespace cca::detail
