// What goes from one environment to another: outputs that are read there, with their delays.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <cca/runtime/environments/exchange/who_asks.hpp>
#include <cca/runtime/state.hpp>

namespace cca::detail {

template <class D, int E>
inline constexpr bool runs_in_cycles<part<D, E>> = is_free_running<D, E>;
template <class D, int E>
inline constexpr bool runs_in_cycles<modes_in<D, E>> = is_free_running<D, E>;
template <class Graph>
inline constexpr bool runs_in_cycles<probed<Graph>> = runs_in_cycles<Graph>;

template <class D>
struct crossings {
  // For each output, the largest delay of a reader in another environment; 0: all readers are here. A wire of
  // a free-running environment may have none: it counts as one beat, because before a beat begins nothing
  // later is needed.
  std::array<int, array_size(output_room_of<D>) + 1> largest_delay{};
  // From an environment to another the least delay; 0: nothing goes there.
  std::array<std::array<int, array_size(environment_count<D>)>, array_size(environment_count<D>)>
      least_delay{};
};

template <class D>
inline constexpr auto crossings_of = [] {
  crossings<D> found;
  const auto& plan = plan_of<D>;
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

// Of all modes: the samples of the one with the largest delay are kept in all of them, and what is needed in
// one is waited for in all of them.
template <DeploymentOfModes D>
inline constexpr auto crossings_of<D> = [] {
  crossings<D> found;
  for_each_deployed_mode<D>([&]<class Mode>() {
    const auto& one = crossings_of<Mode>;
    for (int o = 0; o < counts_of<Mode>.output_count; ++o) {
      int& largest =
          found.largest_delay[array_size(view_of_deployed_mode<D, Mode::cca_mode>.shared_output(o))];
      largest = std::max(largest, one.largest_delay[array_size(o)]);
    }
    for (std::size_t from = 0; from < found.least_delay.size(); ++from)
      for (std::size_t to = 0; to < found.least_delay.size(); ++to)
        if (const int delay = one.least_delay[from][to]; delay > 0) {
          int& least = found.least_delay[from][to];
          if (least == 0 || delay < least) least = delay;
        }
  });
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
    return is_order<D>(number)     ? has_orders<D>
           : is_request<D>(number) ? asks_for_changes<D>(number - counts_of<D>.output_count)
                                   : crossings_of<D>.largest_delay[o] > 0;
  }
};
// Outputs, requests and orders.
template <class D>
using all_that_leaves = chosen<counts_of<D>.output_count + 2 * environment_count<D>, leaves_environment<D>>;
template <class D, int Leaving>
inline constexpr int largest_delay_of = [] {
  if constexpr (is_request<D>(Leaving)) return 1;
  else return crossings_of<D>.largest_delay[Leaving];
}();

template <class D, int E>
struct leaves_by_clock {
  static constexpr bool holds(std::size_t o) {
    const auto& plan = plan_of<D>;
    return plan_of<part<D, E>>.outputs[o].leaves && environment_of(plan.view(), plan.outputs[o].call) == E &&
           published(plan.view(), plan.outputs[o]).known();
  }
};

// Whoever has all samples of an environment's outputs up to a beat knows that it has done the beat: they are
// published by known clocks, and it can't fault after them. `Output`: those whose samples are seen. Where
// one is read at once its reader looks at the position.
template <class D, int E, int... Output>
inline constexpr bool samples_tell = [] {
  if constexpr (DeploymentOfModes<D> || DeployedMode<D>) {
    return false;  // another mode may lack the component
  } else {
    const auto& plan = plan_of<D>;
    const flat_view g = plan.view();
    return !counts_of<part<D, E>>.may_fault && !asks_for_parts<D>(E) &&
           ((is_request<D>(Output) || environment_of(g, g.outputs[Output].call) != E ||
             (published(g, g.outputs[Output]).known() && !is_read_at_once(g, Output))) &&
            ...);
  }
}();

template <class D, int Output>
inline constexpr bool is_of_free_running = [] {
  if constexpr (is_request<D>(Output)) return false;
  const auto& plan = plan_of<D>;
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
    return is_queued(in) && in.writer >= 0 && !plan.calls[array_size(in.call)].elsewhere &&
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

// Environment E reads an output from elsewhere, in some mode.
template <class D, int E, int Output>
constexpr bool is_read_in() {
  if constexpr (DeploymentOfModes<D>) {
    bool is_read = false;
    for_each_deployed_mode<D>([&]<class Mode>() {
      [&]<int... Own>(std::integer_sequence<int, Own...>) {
        ((is_read |= shared_output_of<Mode, Own> == Output && comes<part<Mode, E>>::holds(Own)), ...);
      }(std::make_integer_sequence<int, counts_of<Mode>.output_count>{});
    });
    return is_read;
  } else {
    return comes<part<D, E>>::holds(Output);
  }
}

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
  const auto& plan = plan_of<D>;
  const flat_view g = plan.view();
  int most = 0;
  for (int i = g.outputs[Output].first_reader; i >= 0; i = g.inputs[i].next_of_writer)
    if (const auto& in = g.inputs[i];
        in.queue >= 0 && environment_of(g, in.call) != environment_of(g, g.outputs[Output].call))
      most = std::max(most, in.wire->capacity);
  return most;
}();

template <DeploymentOfModes D, int Output>
inline constexpr int most_waiting<D, Output> = [] {
  int most = 0;
  for_each_deployed_mode<D>([&]<class Mode>() {
    [&]<int... Own>(std::integer_sequence<int, Own...>) {
      ((most = shared_output_of<Mode, Own> == Output ? std::max(most, most_waiting<Mode, Own>) : most), ...);
    }(std::make_integer_sequence<int, counts_of<Mode>.output_count>{});
  });
  return most;
}();

// The ways from one environment to another into a queue that keeps what came first.
template <class D>
struct keeps_first {
  static constexpr bool holds(std::size_t i) {
    const auto& plan = plan_of<D>;
    const flat_view g = plan.view();
    const input& in = g.inputs[i];
    return is_queued(in) && in.writer >= 0 && in.wire->full == full_kind::drop_newest &&
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
  if constexpr (DeploymentOfModes<D> || DeployedMode<D>) return false;
  else
    return []<int... Output>(std::integer_sequence<int, Output...>) {
      const auto& plan = plan_of<D>;
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
