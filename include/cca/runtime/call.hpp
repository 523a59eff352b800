// The call of one function in a beat: whether it fires, what it sees, the call; what it publishes is in
// runtime/publish.hpp.
#pragma once

#include <limits>

#include <cca/runtime/strategy_inputs.hpp>
#include <cca/runtime/publish.hpp>

namespace cca::detail {

// One argument of the call, for all inputs that are alike.
template <class Graph, int Input, class Parameter>
struct argument {
  template <int Position, class Places>
  CCA_GLUE static Parameter get(
      const memory<Graph>&, const Places& places, std::int64_t k, std::int64_t last, beat) {
    return filled(input_in<Position>(places), k, last);
  }
  CCA_GLUE static Parameter filled(const input_seat<Graph, Input>& seat, std::int64_t k, std::int64_t last) {
    Parameter port{to_be_filled{}};
    fill_port<Graph, Input>(port, seat, k, last);
    return port;
  }
};
template <class Graph, int Input>
struct argument<Graph, Input, beat> {
  template <int, class Places>
  CCA_GLUE static beat get(const memory<Graph>&, const Places&, std::int64_t, std::int64_t, beat now) {
    return now;
  }
};
template <class Graph, int Input, fixed_string Scope, class Policy>
struct argument<Graph, Input, observe<Scope, Policy>> {
  template <int, class Places>
  CCA_GLUE static observations<Graph, Input> get(
      const memory<Graph>& m, const Places&, std::int64_t k, std::int64_t last, beat) {
    return {m, k, last};
  }
};

template <class Graph, int Input>
inline constexpr bool counts_for_origin = input_of<Graph, Input>.writer >= 0 && input_of<Graph, Input>.counts;

// Its sample has surely arrived when the component fires, so that its origin is not `never`.
template <class Graph, int Input>
inline constexpr bool surely_arrived =
    counts_for_origin<Graph, Input> && input_of<Graph, Input>.in_beat && delay_of_input<Graph, Input> == 0;

template <class Graph, int... Input>
constexpr int first_sure(std::integer_sequence<int, Input...>) {
  int first = -1, position = 0;
  ((first < 0 && surely_arrived<Graph, Input> ? void(first = position) : void(), ++position), ...);
  return first;
}

// Queues show what was taken. An input that does not count nodes the oldest as it is.
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

// The oldest origin among the inputs as they were; `never` where none counts. Where it is settled at compile
// time that a sample has arrived nothing is asked at run time: in a chain each question would depend on the
// one before.
template <class Graph, class Places, int... Input, int... Position>
CCA_GLUE std::int64_t oldest_wired([[maybe_unused]] const Places& places,
                                   [[maybe_unused]] std::int64_t k,
                                   std::integer_sequence<int, Input...>,
                                   std::integer_sequence<int, Position...>) {
  constexpr int first = first_sure<Graph>(std::integer_sequence<int, Input...>{});
  std::int64_t oldest = never;
  ((Position == first ? add_origin<Graph, Input, true>(oldest, input_in<Position>(places), k) : void()), ...);
  ((Position == first ? void() : add_origin<Graph, Input, false>(oldest, input_in<Position>(places), k)),
   ...);
  return oldest;
}

// The same where observers listen too.
template <class Graph, int Call>
CCA_GLUE std::int64_t oldest_heard(const memory<Graph>& m, std::int64_t k, std::int64_t oldest) {
  for_each_observed<Graph, Call>([&]<int Link>() {
    if constexpr (plan_of<Graph>.links[Link].counts)
      oldest = older(oldest, observe_one<Graph, Link>(m, k).origin);
  });
  return oldest;
}

// Does a function have an input with a queue?
template <class Graph>
constexpr bool has_queue(const call& t) {
  for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i)
    if (is_queued(plan_of<Graph>.inputs[static_cast<std::size_t>(i)])) return true;
  return false;
}

// Beats since the last firing, where the clock is known.
template <clock Clock, bool IsTimed>
CCA_GLUE constexpr std::int64_t beats_since(std::int64_t k) {
  if constexpr (Clock.period == 1 || IsTimed) return Clock.period;
  else return k == Clock.first ? 1 : Clock.period;
}

// One function of a component, for all that are alike.
template <class Graph, int Call, class Parameters>
struct function_in_beat;
template <class Graph, int Call, class... Parameters>
struct function_in_beat<Graph, Call, list<Parameters...>> {
  static constexpr const auto& t = call_of<Graph, Call>;
  static constexpr std::int64_t period = counts_of<Graph>.period;
  using types = node_types<Graph, t.node>;
  using component = typename types::component;
  using function = function_facts<typename function_of<component, t.phase>::type>;
  using facts = function_ports<list<Parameters...>, list<>>;
  using all_parameters = std::make_integer_sequence<int, sizeof...(Parameters)>;
  using all_inputs = input_positions<Graph, Call>;

  memory<Graph>& m;
  beat_outcome& on;
  std::int64_t k;
  int node;
  seats<Graph, Call> places;

  CCA_GLUE static void take_turn(memory<Graph>& m,
                                 [[maybe_unused]] locals<Graph>& l,
                                 beat_outcome& on,
                                 std::int64_t k,
                                 const call_place& of) {
    if constexpr (!t.fires.never()) {
      auto& self = cells_at<Graph, layout_of<Graph>.cells[t.node].group>(m).at(of.component);
      const function_in_beat one{m, on, k, of.node, {m, l, of}};
      if constexpr (t.fires.dynamic()) {
        one.ask(self, m.firings[of.firing]);
      } else {
        constexpr auto strategy = plan_of<Graph>.nodes[t.node].item->strategy;
        constexpr bool is_timed = strategy && strategy->first_dt_is_period;
        if constexpr (!t.fires.every_beat())
          if (!ticks<t.fires>(k)) return;
        one.fire(self, {k, period, beats_since<t.fires, is_timed>(k)},
                 k == t.fires.first ? -1 : k - t.fires.period);
      }
    }
  }

  CCA_GLUE void ask(component& self, last_firing& own) const {
    using strategy =
        typename strategy_or_default<typename types::strategy, (t.function->input_count > 0)>::type;
    if (!strategy_fires<strategy>(question<Graph, Call>{m, places, k, own})) return;
    if constexpr (t.stored_seen) own.oldest = oldest_seen(all_inputs{});
    const std::int64_t last = own.last;
    own.last = k;
    fire(self, {k, period, last < 0 ? 1 : k - last}, last);
  }

  CCA_GLUE void fire(component& self, beat now, std::int64_t last) const {
    if constexpr (std::is_void_v<typename function::result>) {
      call(self, now, last, all_parameters{});
      if constexpr (has_queue<Graph>(t)) take_all(all_inputs{});
    } else {
      const typename function::result result = call(self, now, last, all_parameters{});
      if constexpr (has_queue<Graph>(t)) take_all(all_inputs{});
      std::int64_t oldest = k * period;
      if constexpr (t.phase != phase_of_beat::sense) {
        oldest = oldest_wired<Graph>(places, k, inputs_like<Graph, Call>{}, all_inputs{});
        if constexpr (has_observers(t)) oldest = oldest_heard<Graph, Call>(m, k, oldest);
        if constexpr (first_sure<Graph>(inputs_like<Graph, Call>{}) < 0)
          if (oldest == never) oldest = k * period;
      }
      publish_all<Graph, outputs_like<Graph, Call>>(result, places, m, on, k, oldest, node,
                                                    typename function::results{});
    }
  }

  // The number of an input that a parameter shows: an observer's own, else the first that is alike; of a
  // beat, any.
  static constexpr int input_shown(int parameter) {
    const int position = facts::input_of_parameter[static_cast<std::size_t>(parameter)];
    return position < 0 ? -1 : layout_of<Graph>.like_input[t.first_input + position];
  }

  // The arguments are made in place: a function in between would copy them.
  template <int... I>
  CCA_GLUE typename function::result call(component& self,
                                          beat now,
                                          std::int64_t last,
                                          std::integer_sequence<int, I...>) const {
    if constexpr (t.phase == phase_of_beat::process)
      CCA_INLINE_CALL return self.process(
          argument<Graph, input_shown(I), Parameters>::template get<facts::input_of_parameter[I]>(
              m, places, k, last, now)...);
    else if constexpr (t.phase == phase_of_beat::sense)
      CCA_INLINE_CALL return self.sense(
          argument<Graph, input_shown(I), Parameters>::template get<facts::input_of_parameter[I]>(
              m, places, k, last, now)...);
    else
      CCA_INLINE_CALL return self.act(
          argument<Graph, input_shown(I), Parameters>::template get<facts::input_of_parameter[I]>(
              m, places, k, last, now)...);
  }

  template <int... Position>
  CCA_GLUE void take_all(std::integer_sequence<int, Position...>) const {
    (take_one<input_like<Graph, Call, Position>>(input_in<Position>(places)), ...);
  }
  template <int Input>
  CCA_GLUE static void take_one(const input_seat<Graph, Input>& seat) {
    if constexpr (input_of<Graph, Input>.queue >= 0) take(seat.at);
  }

  // Initial values count here as what they are: of the lowest origin.
  template <int... Position>
  CCA_GLUE std::int64_t oldest_seen(std::integer_sequence<int, Position...>) const {
    std::int64_t oldest = std::numeric_limits<std::int64_t>::max();
    (see<input_like<Graph, Call, Position>>(oldest, input_in<Position>(places)), ...);
    return oldest;
  }
  template <int Input>
  CCA_GLUE void see(std::int64_t& oldest, const input_seat<Graph, Input>& seat) const {
    if constexpr (is_wired<Graph, Input>) {
      const std::int64_t origin = origin_of<Graph, Input>(seat, k);
      oldest = origin < oldest ? origin : oldest;
    }
  }
};

template <class Graph, int Call>
using function_like = function_in_beat<Graph,
                                       Call,
                                       typename function_facts<typename function_of<
                                           typename node_types<Graph, call_of<Graph, Call>.node>::component,
                                           call_of<Graph, Call>.phase>::type>::parameters>;

}  // namespace cca::detail
