// The turn of one function in a beat: whether it fires, what it sees, the call, and what it publishes.
#pragma once

#include <limits>
#include <tuple>

#include <cca/runtime/fires.hpp>
#include <cca/runtime/observe.hpp>

namespace cca::detail {

// What one beat carries along: the reason of a fault, once there is one.
struct course {
  const char* fault = nullptr;
  int leaf = -1;
};

// One argument of the call.
template <class Graph, int Turn, int Input, class Parameter>
struct argument {
  CCA_GLUE static Parameter get(const memory<Graph>&, const input_seat<Graph, Input>& seat, std::int64_t k, std::int64_t last, beat) {
    Parameter port{to_be_filled{}};
    fill_port<Graph, Input>(port, seat, k, last);
    return port;
  }
};
template <class Graph, int Turn, int Input>
struct argument<Graph, Turn, Input, beat> {
  CCA_GLUE static beat get(const memory<Graph>&, const seats<Graph, Turn>&, std::int64_t, std::int64_t, beat now) { return now; }
};
template <class Graph, int Turn, int Input, fixed_string Scope, class Policy>
struct argument<Graph, Turn, Input, observe<Scope, Policy>> {
  CCA_GLUE static observations<Graph, Input> get(const memory<Graph>& m, const seats<Graph, Turn>&, std::int64_t k, std::int64_t last, beat) {
    return {m, k, last};
  }
};

template <class Graph, int Input>
inline constexpr bool counts_for_origin = input_of<Graph, Input>.writer >= 0 && input_of<Graph, Input>.counts;

// Its sample has surely arrived when the component fires, so that its origin is not `never`.
template <class Graph, int Input>
inline constexpr bool surely_arrived = counts_for_origin<Graph, Input> && input_of<Graph, Input>.in_beat && delay_of_input<Graph, Input> == 0;

template <class Graph, int... Input>
constexpr int first_sure(std::integer_sequence<int, Input...>) {
  int first = -1;
  ((first < 0 && surely_arrived<Graph, Input> ? void(first = Input) : void()), ...);
  return first;
}

// Queues show what was taken. An input that does not count leaves the oldest as it is.
template <class Graph, int Input, bool IsFirst>
CCA_GLUE void add_origin(std::int64_t& oldest, const input_seat<Graph, Input>& seat, std::int64_t k) {
  if constexpr (surely_arrived<Graph, Input>) {
    const std::int64_t origin = origin_of<Graph, Input>(seat, k);
    if constexpr (IsFirst) oldest = origin;
    else oldest = origin < oldest ? origin : oldest;
  } else if constexpr (counts_for_origin<Graph, Input>) {
    if constexpr (input_of<Graph, Input>.queue >= 0) oldest = older(oldest, seat.at.taken.origin);
    else oldest = older(oldest, origin_of<Graph, Input>(seat, k));
  }
}

// The oldest origin among the inputs as they were; the beat's time where none counts. Where it is settled at compile time
// that a sample has arrived nothing is asked at run time: in a chain each question would depend on the one before.
template <class Graph, int Turn, int... Input>
CCA_GLUE std::int64_t oldest_origin([[maybe_unused]] const memory<Graph>& m, [[maybe_unused]] const seats<Graph, Turn>& places, std::int64_t k, std::integer_sequence<int, Input...>) {
  constexpr int first = first_sure<Graph>(std::integer_sequence<int, Input...>{});
  std::int64_t oldest = never;
  if constexpr (first >= 0) add_origin<Graph, first, true>(oldest, places, k);
  ((Input == first ? void() : add_origin<Graph, Input, false>(oldest, places, k)), ...);
  if constexpr (has_observers<Graph, Turn>())
    for_each_observed<Graph, Turn>([&]<int Link>() { oldest = older(oldest, observe_one<Graph, Link>(m, k).origin); });
  if constexpr (first >= 0) return oldest;
  else return oldest == never ? k * counts_of<Graph>.period : oldest;
}

template <class Graph, int Input, class Queue, class Value>
CCA_GLUE void push(Queue& q, course& course, const Value& value, std::int64_t origin) {
  constexpr const auto& in = input_of<Graph, Input>;
  if (q.count == q.capacity) {
    if constexpr (in.wire->full == full_kind::drop_oldest) {
      q.head = q.head + 1 == q.capacity ? 0 : q.head + 1;
      --q.count;
    } else {
      if constexpr (in.wire->full == full_kind::reject) course = {"a sample arrived while the queue was full", turn_of<Graph, in.turn>.leaf};
      return;
    }
  }
  const int at = q.head + q.count;
  auto& place = q.ring[at < q.capacity ? at : at - q.capacity];
  copy_coordinates<size_of_input<Graph, Input>>(place.value, value);
  place.origin = origin;
  ++q.count;
}

// Into the queues among the readers of an output, from reader `Input` on.
template <class Graph, int Input, class Value>
CCA_GLUE void push_to_queues(memory<Graph>& m, course& course, const Value& value, std::int64_t origin) {
  if constexpr (Input >= 0) {
    constexpr seat queue = layout_of<Graph>.sources[Input];
    if constexpr (input_of<Graph, Input>.queue >= 0) push<Graph, Input>(stored_at<Graph, queue.group>(m, m, queue.slot), course, value, origin);
    push_to_queues<Graph, input_of<Graph, Input>.next_of_writer>(m, course, value, origin);
  }
}

template <int Size, class Sample, class Value>
CCA_GLUE void store(Sample& to, const Value& value, std::int64_t origin) {
  copy_coordinates<Size>(to.value, value);
  to.origin = origin;
}

template <class Graph, int Output, class Result>
CCA_GLUE void publish(const Result& result, memory<Graph>& m, const output_seat<Graph, Output>& seat, course& course, std::int64_t k, std::int64_t oldest) {
  constexpr const auto& out = output_of<Graph, Output>;
  if constexpr (requires { result.operator bool(); })
    if (!result) return;
  const std::int64_t own = result.origin();
  const std::int64_t origin = own == never ? oldest : own;
  const auto& value = result.vector();
  if constexpr (out.kept || out.local) {
    auto& newest = seat.newest.at;
    store<size_of_output<Graph, Output>>(newest, value, origin);
    if constexpr (!out.kept && !is_sure<Graph, Output>) newest.published = true;
    if constexpr (out.kept && out.stamped) newest.when = k;
  }
  if constexpr (out.ring > 0) {
    constexpr auto c = published_of<Graph, Output>;
    std::int64_t at;
    if constexpr (c.known()) at = (k - c.first) / c.period;
    else at = seat.past.at.count++;
    auto& entry = seat.past.at.entries[static_cast<std::size_t>(at) & static_cast<std::size_t>(out.ring - 1)];
    store<size_of_output<Graph, Output>>(entry, value, origin);
    entry.when = k;
  }
  if constexpr (out.first_reader >= 0) push_to_queues<Graph, out.first_reader>(m, course, value, origin);
}

// Beats since the last firing, where the clock is known.
template <class Graph, int Turn>
CCA_GLUE constexpr std::int64_t beats_since(std::int64_t k) {
  constexpr const auto& t = turn_of<Graph, Turn>;
  constexpr auto c = t.fires;
  constexpr bool is_timed = plan_of<Graph>.leaves[t.leaf].item->strategy->kind == strategy_kind::timed;
  if constexpr (c.period == 1 || is_timed) return c.period;
  else return k == c.first ? 1 : c.period;
}

// One function of a component, for all that are alike.
template <class Graph, int Turn, class Parameters>
struct function_in_beat;
template <class Graph, int Turn, class... Parameters>
struct function_in_beat<Graph, Turn, list<Parameters...>> {
  static constexpr const auto& t = turn_of<Graph, Turn>;
  static constexpr std::int64_t period = counts_of<Graph>.period;
  using leaf_facts = leaf_of<Graph, t.leaf>;
  using component = typename leaf_facts::component;
  using function = function_facts<typename function_of<component, t.phase>::type>;
  using facts = half_facts<list<Parameters...>, list<>>;
  using all_parameters = std::make_integer_sequence<int, sizeof...(Parameters)>;
  using all_inputs = inputs_of<Graph, Turn>;

  memory<Graph>& m;
  course& on;
  std::int64_t k;
  int leaf;
  seats<Graph, Turn> places;

  // The arguments are made in place: a function in between would copy them.
  template <int... I>
  CCA_GLUE typename function::result call(component& self, beat now, std::int64_t last, std::integer_sequence<int, I...>) const {
    if constexpr (t.phase == phase_of_beat::process)
      CCA_INLINE_CALL return self.process(argument<Graph, Turn, t.first_input + facts::input_of_parameter[I], Parameters>::get(m, places, k, last, now)...);
    else if constexpr (t.phase == phase_of_beat::sense)
      CCA_INLINE_CALL return self.sense(argument<Graph, Turn, t.first_input + facts::input_of_parameter[I], Parameters>::get(m, places, k, last, now)...);
    else
      CCA_INLINE_CALL return self.act(argument<Graph, Turn, t.first_input + facts::input_of_parameter[I], Parameters>::get(m, places, k, last, now)...);
  }

  CCA_GLUE void fire(component& self, beat now, std::int64_t last) const {
    if constexpr (std::is_void_v<typename function::result>) {
      call(self, now, last, all_parameters{});
      take_all(all_inputs{});
    } else {
      const typename function::result result = call(self, now, last, all_parameters{});
      take_all(all_inputs{});
      std::int64_t oldest = k * period;
      if constexpr (t.phase != phase_of_beat::sense) oldest = oldest_origin<Graph, Turn>(m, places, k, all_inputs{});
      publish_all(result, oldest, typename function::results{});
    }
  }

  template <class Result>
  CCA_GLUE void publish_all(const Result& result, std::int64_t oldest, list<Result>) const {
    publish_one<0>(result, oldest, half_facts<list<>, list<Result>>{});
  }
  template <class... Results>
  CCA_GLUE void publish_all(const std::tuple<Results...>& result, std::int64_t oldest, list<Results...>) const {
    publish_each(result, oldest, half_facts<list<>, list<Results...>>{}, std::make_index_sequence<sizeof...(Results)>{});
  }
  template <class Result, class Positions, std::size_t... I>
  CCA_GLUE void publish_each(const Result& result, std::int64_t oldest, Positions positions, std::index_sequence<I...>) const {
    (publish_one<I>(std::get<I>(result), oldest, positions), ...);
  }
  template <std::size_t I, class Result, class Positions>
  CCA_GLUE void publish_one(const Result& result, std::int64_t oldest, Positions) const {
    if constexpr (std::is_same_v<Result, fault>) {
      if (result) on = {result.reason(), leaf};
    } else {
      publish<Graph, t.first_output + Positions::output_of_result[I]>(result, m, places, on, k, oldest);
    }
  }

  template <int... Input>
  CCA_GLUE void take_all(std::integer_sequence<int, Input...>) const {
    (take_one<Input>(places), ...);
  }
  template <int Input>
  CCA_GLUE static void take_one(const input_seat<Graph, Input>& seat) {
    if constexpr (input_of<Graph, Input>.queue >= 0) take(seat.at);
  }

  // Initial values count here as what they are: of the lowest origin.
  template <int... Input>
  CCA_GLUE std::int64_t oldest_seen(std::integer_sequence<int, Input...>) const {
    std::int64_t oldest = std::numeric_limits<std::int64_t>::max();
    const auto one = [&](std::int64_t origin) { oldest = origin < oldest ? origin : oldest; };
    ((is_wired<Graph, Input> ? one(origin_of<Graph, Input>(places, k)) : void()), ...);
    return oldest;
  }

  // With a clock that is known.
  CCA_GLUE void turn(component& self) const {
    if constexpr (!t.fires.every_beat())
      if (!ticks<t.fires>(k)) return;
    fire(self, beat{k, period, beats_since<Graph, Turn>(k)}, k == t.fires.first ? -1 : k - t.fires.period);
  }

  CCA_GLUE void turn(component& self, last_firing& own) const {
    using strategy = typename strategy_or_default<typename leaf_facts::strategy, (t.half->input_count > 0)>::type;
    if (!asking<strategy>::template fires<Graph, Turn>(question<Graph, Turn>{m, places, k, own})) return;
    if constexpr (t.stored_seen) own.oldest = oldest_seen(all_inputs{});
    const std::int64_t last = own.last;
    own.last = k;
    fire(self, beat{k, period, last < 0 ? 1 : k - last}, last);
  }
};

template <class Graph, int Turn>
using function_like = function_in_beat<Graph, Turn, typename function_facts<typename function_of<typename leaf_of<Graph, turn_of<Graph, Turn>.leaf>::component, turn_of<Graph, Turn>.phase>::type>::parameters>;

// All that is compiled anew for each function: where its component and its samples lie.
template <class Graph, int Turn, int... I, int... O>
CCA_GLUE void take_turn(memory<Graph>& m, locals<Graph>& l, course& on, std::int64_t k, std::integer_sequence<int, I...>, std::integer_sequence<int, O...>) {
  constexpr const turn& t = plan_of<Graph>.turns[Turn];
  constexpr const auto& lay = layout_of<Graph>;
  constexpr int in = t.first_input, out = t.first_output;
  if constexpr (counts_of<Graph>.may_fault)
    if (on.fault) return;
  const function_like<Graph, lay.like[Turn]> one{m, on, k, t.leaf, {
      {refer<Graph, lay.sources[in + I].group>(m, l, lay.sources[in + I].slot)}...,
      {refer<Graph, lay.newest[out + O].group>(m, l, lay.newest[out + O].slot), refer<Graph, lay.past[out + O].group>(m, l, lay.past[out + O].slot)}...}};
  if constexpr (lay.firings[Turn] >= 0) one.turn(component_at<Graph, t.leaf>(m), m.firings[lay.firings[Turn]]);
  else one.turn(component_at<Graph, t.leaf>(m));
}

template <class Graph, int Turn>
CCA_GLUE void take_turn(memory<Graph>& m, locals<Graph>& l, course& on, std::int64_t k) {
  constexpr const turn& t = plan_of<Graph>.turns[Turn];
  if constexpr (!t.fires.never())
    take_turn<Graph, Turn>(m, l, on, k, std::make_integer_sequence<int, t.half->input_count>{}, std::make_integer_sequence<int, t.half->output_count>{});
}

}  // namespace cca::detail
