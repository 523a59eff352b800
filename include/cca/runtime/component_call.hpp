// One call of a component's function in a beat: whether it fires, what it sees, and the call itself. What it
// returns is published by runtime/publish.hpp.
#pragma once

#include <limits>
#include <new>

#include <cca/runtime/publish.hpp>
#include <cca/runtime/strategy_inputs.hpp>

namespace cca::detail {

// The origins that count for what a component publishes.
template <class Graph, int Input>
inline constexpr bool counts_for_origin = is_wired<Graph, Input> && input_of<Graph, Input>.counts;

// Its sample has arrived whenever the component fires, so its origin is not `never`.
template <class Graph, int Input>
inline constexpr bool has_surely_arrived =
    counts_for_origin<Graph, Input> && input_of<Graph, Input>.in_beat && input_of<Graph, Input>.delay == 0;

// Beats since the last firing, where the clock is known.
template <clock Clock, bool IsTimed>
CCA_INLINE constexpr std::int64_t beats_since(std::int64_t k) {
  if constexpr (Clock.period == 1 || IsTimed) return Clock.period;
  else return k == Clock.first ? 1 : Clock.period;
}

// `Call` is the first of all its twins; `at` says what this one touches.
template <class Graph, int Call, class Parameters, class Inputs>
struct component_call_of;

template <class Graph, int Call, class... Parameters, int... Position>
struct component_call_of<Graph, Call, list<Parameters...>, std::integer_sequence<int, Position...>> {
  static constexpr const auto& c = call_of<Graph, Call>;
  static constexpr std::int64_t period = counts_of<Graph>.period;
  using component = typename node_types<Graph, c.node>::component;
  using result = typename function_called<Graph, Call>::result;

  const beat_context<Graph>& b;
  const call_place& at;

  // Calls the function, if it fires in this beat.
  CCA_INLINE static void run(const beat_context<Graph>& b, const call_place& at) {
    const component_call_of one{b, at};
    if constexpr (c.fires.never()) {
      return;
    } else if constexpr (c.fires.dynamic()) {
      one.ask_strategy();
    } else {
      constexpr auto strategy = plan_of<Graph>.nodes[c.node].item->strategy;
      constexpr bool is_timed = strategy && strategy->first_dt_is_period;
      if constexpr (!c.fires.every_beat())
        if (!ticks<c.fires>(b.k)) return;
      one.fire({b.k, period, beats_since<c.fires, is_timed>(b.k)},
               b.k == c.fires.first ? -1 : b.k - c.fires.period);
    }
  }

private:
  CCA_INLINE void ask_strategy() const {
    last_firing& own = b.state.firings[at.firing];
    using strategy = typename strategy_or_default<typename node_types<Graph, c.node>::strategy,
                                                  (sizeof...(Position) > 0)>::type;
    if (!strategy_fires<strategy>(question<Graph, Call>{b, at, own})) return;
    if constexpr (c.stored_seen) own.oldest = oldest_seen();
    const std::int64_t last = own.last;
    own.last = b.k;
    fire({b.k, period, last < 0 ? 1 : b.k - last}, last);
  }

  CCA_INLINE void fire(beat now, std::int64_t last) const {
    constexpr auto parameters = std::index_sequence_for<Parameters...>{};
    auto& self = component_in<Graph, layout_of<Graph>.components[c.node].array>(b.state, at.component);
    if constexpr (std::is_void_v<result>) {
      call(self, now, last, parameters);
      take_from_queues();
    } else if constexpr (constexpr int array = layout_of<Graph>.results[Call].array; array >= 0) {
      auto& stored = b.template at<array>(at.result);
      result& returned = *::new (stored.place()) result(call(self, now, last, parameters));
      take_from_queues();
      publish_all<Graph, Call>(b, returned, at, origin());
    } else {
      result returned = call(self, now, last, parameters);
      take_from_queues();
      publish_all<Graph, Call>(b, returned, at, origin());
    }
  }

  // The arguments are made in place: a function in between would copy them.
  template <std::size_t... I>
  CCA_INLINE result call(component& self, beat now, std::int64_t last, std::index_sequence<I...>) const {
    using ports = function_ports<list<Parameters...>, list<>>;
    if constexpr (c.phase == phase_of_beat::process)
      CCA_INLINE_CALL return self.process(argument<Parameters, ports::input_of_parameter[I]>(now, last)...);
    else if constexpr (c.phase == phase_of_beat::sense)
      CCA_INLINE_CALL return self.sense(argument<Parameters, ports::input_of_parameter[I]>(now, last)...);
    else CCA_INLINE_CALL return self.act(argument<Parameters, ports::input_of_parameter[I]>(now, last)...);
  }
  template <class Parameter, int P>
  CCA_INLINE auto argument([[maybe_unused]] beat now, [[maybe_unused]] std::int64_t last) const {
    if constexpr (P < 0) {
      return now;
    } else if constexpr (!c.function->inputs[P < 0 ? 0 : P].space) {
      return observations<Graph, c.first_input + P>(b, last);
    } else {
      return input_reader<Graph, input_at<Graph, Call, P>>::template port<Parameter>(
          b, index_of_source<Graph>(at, P), last);
    }
  }

  CCA_INLINE void take_from_queues() const {
    (input_reader<Graph, input_at<Graph, Call, Position>>::take(b, index_of_source<Graph>(at, Position)),
     ...);
  }

  // The oldest origin among the inputs as they were; where none counts, the beat's time. Where it is known
  // while compiling that a sample has arrived, nothing is asked while running: in a chain each question would
  // depend on the one before.
  CCA_INLINE std::int64_t origin() const {
    const std::int64_t time = b.k * period;
    if constexpr (c.phase == phase_of_beat::sense) {
      return time;
    } else {
      constexpr bool is_known = (has_surely_arrived<Graph, input_at<Graph, Call, Position>> || ...);
      std::int64_t oldest = is_known ? std::numeric_limits<std::int64_t>::max() : never;
      (add_known_origin<Position>(oldest), ...);
      (add_other_origin<Position>(oldest), ...);
      if constexpr (has_observers(c)) oldest = oldest_heard<Graph, Call>(b, oldest);
      if constexpr (!is_known)
        if (oldest == never) oldest = time;
      return oldest;
    }
  }
  template <int P>
  CCA_INLINE void add_known_origin(std::int64_t& oldest) const {
    constexpr int input = input_at<Graph, Call, P>;
    if constexpr (has_surely_arrived<Graph, input>) {
      const std::int64_t one = input_reader<Graph, input>::origin(b, index_of_source<Graph>(at, P));
      oldest = one < oldest ? one : oldest;
    }
  }
  template <int P>
  CCA_INLINE void add_other_origin(std::int64_t& oldest) const {
    constexpr int input = input_at<Graph, Call, P>;
    if constexpr (counts_for_origin<Graph, input> && !has_surely_arrived<Graph, input>) {
      oldest = older(oldest, input_reader<Graph, input>::origin_seen(b, index_of_source<Graph>(at, P)));
    }
  }

  // For `coordinated`: the oldest origin that it sees. Initial values have the lowest.
  CCA_INLINE std::int64_t oldest_seen() const {
    std::int64_t oldest = std::numeric_limits<std::int64_t>::max();
    (add_seen<Position>(oldest), ...);
    return oldest;
  }
  template <int P>
  CCA_INLINE void add_seen(std::int64_t& oldest) const {
    constexpr int input = input_at<Graph, Call, P>;
    if constexpr (is_wired<Graph, input>) {
      const std::int64_t one = input_reader<Graph, input>::origin(b, index_of_source<Graph>(at, P));
      oldest = one < oldest ? one : oldest;
    }
  }
};

template <class Graph, int Call>
using component_call = component_call_of<Graph,
                                         Call,
                                         typename function_called<Graph, Call>::parameters,
                                         input_positions<Graph, Call>>;

}  // namespace cca::detail
