// One call of a component's function in a beat: whether it fires, what it sees, the call itself, and what it
// returns.
#pragma once

#include <algorithm>
#include <limits>
#include <new>

#include <cca/runtime/publish.hpp>
#include <cca/runtime/strategy_inputs.hpp>

namespace cca::detail {

// Does a function have an input with a queue?
template <class Graph>
constexpr bool has_queue(const call& c) {
  for (int i = c.first_input; i < c.first_input + c.function->input_count; ++i)
    if (is_queued(plan_of<Graph>.inputs[static_cast<std::size_t>(i)])) return true;
  return false;
}

template <clock Clock>
CCA_INLINE constexpr bool ticks(std::int64_t k) {
  if constexpr (Clock.never()) return false;
  else if constexpr (Clock.every_beat()) return true;
  else if constexpr (Clock.period == 1) return k >= Clock.first;
  else if constexpr (Clock.first < Clock.period)
    return static_cast<std::uint64_t>(k) % static_cast<std::uint64_t>(Clock.period) ==
           static_cast<std::uint64_t>(Clock.first);
  else return k >= Clock.first && (k - Clock.first) % Clock.period == 0;
}

// Of a deployment: is it in a fast run? A replay knows what was recorded (record/replay/played_samples.hpp).
template <class Graph>
struct in_fast_run {
  CCA_INLINE static bool is_now(const auto& b) { return b.state.is_exact; }
};

template <std::int64_t Period>
struct firing {
  bool is_now = false;
  double dt = 0;           // s, since the last one
  std::int64_t last = -1;  // beat of the last one; -1: none

  CCA_INLINE firing() = default;
  CCA_INLINE firing(bool now, std::int64_t beats_since, std::int64_t last_beat)
      : is_now(now), dt(beat_of_seconds::seconds(Period, beats_since)), last(last_beat) {}
};

template <class Results>
struct numbers_of;
template <class... Results>
struct numbers_of<list<Results...>> {
  using type = std::index_sequence_for<Results...>;
};
template <class Results>
using result_numbers = typename numbers_of<Results>::type;

// `Call` is the first of all its twins; `at` says what this one touches. `Position` are the wired inputs,
// `Number` the results.
template <class Graph, int Call, class Parameters, class Results, class Inputs, class Numbers>
struct component_call_of;

template <class Graph,
          int Call,
          class... Parameters,
          class... Results,
          int... Position,
          std::size_t... Number>
struct component_call_of<Graph,
                         Call,
                         list<Parameters...>,
                         list<Results...>,
                         std::integer_sequence<int, Position...>,
                         std::index_sequence<Number...>> {
  static constexpr const auto& c = call_of<Graph, Call>;
  static constexpr std::int64_t period = counts_of<Graph>.period;
  static constexpr int part = part_of_call_at<Graph, Call>;
  using types = node_types<Graph, c.node>;
  using component = typename types::component;
  using result = typename function_called<Graph, Call>::result;

  using firing = detail::firing<period>;
  static constexpr bool takes = has_queue<Graph>(c) || has_observers(c);

  const beat_context<Graph>& b;
  const call_place& at;

  // Calls the function if it fires in this beat, and publishes what it returns.
  CCA_INLINE static void run(const beat_context<Graph>& b, const call_place& at) {
    const component_call_of one{b, at};
    const firing now = one.fires();
    if (!now.is_now) return;
    if constexpr (std::is_void_v<result>) {
      one.call(now, std::index_sequence_for<Parameters...>{});
      if constexpr (takes) one.take_from_queues();
    } else {
      result_of_beat<result, true> unread;  // by other calls of this beat
      result& returned = *::new (one.place_of_result(unread))
                             result(one.call(now, std::index_sequence_for<Parameters...>{}));
      const std::int64_t oldest = one.origin();
      if constexpr (takes) one.take_from_queues();
      if constexpr (std::is_same_v<result, std::tuple<Results...>>)
        (publish<Graph, Call, output_of_result<Number>>(b, at, std::get<Number>(returned), oldest), ...);
      else publish<Graph, Call, 0>(b, at, returned, oldest);
    }
    if (trace_track* const track = trace_of<Graph>(b.state)) [[unlikely]]
      track->fired(trace_name(at.node, c.phase));
  }

private:
  template <std::size_t I>
  static constexpr int output_of_result = function_ports<list<>, list<Results...>>::output_of_result[I];

  // Of a part only while that is started.
  CCA_INLINE firing fires() const {
    if constexpr (part >= 0)
      if (b.rests[array_size(part)] && !is_played()) return {};
    firing now = fires_while_started();
    if constexpr (c.may_miss)
      if (b.is_after_missed) [[unlikely]]
        if (now.is_now) correct(now);
    return now;
  }
  // It missed the firing that its clock tells.
  CCA_INLINE void correct(firing& now) const {
    const missed_firing& missed = b.state.missed[array_size(at.missed)];
    std::int64_t beats = c.own_clock.period, before = -1;
    if constexpr (c.own_clock.dynamic()) beats = b.k - now.last;  // in a deployment: of the whole it is known
    const std::int64_t tick = b.k - beats;
    if (missed.in != tick) return;
    if constexpr (c.own_clock.known()) {
      if (tick < known_since()) return;
      if constexpr (runs_in_cycles<Graph>) beats = b.state.beats_since;
    }
    if constexpr (part >= 0) before = b.state.parts[array_size(part)].since - 1;
    now = missed.last >= 0 ? firing(true, beats + missed.beats, missed.last)
                           : firing(true, first_beats, before);
  }
  // Settled at compile time if the clock is known; else its strategy is asked.
  CCA_INLINE firing fires_while_started() const {
    if constexpr (c.own_clock.never()) {
      return {};
    } else if constexpr (c.own_clock.dynamic()) {
      last_firing& own = b.state.firings[at.firing];
      using strategy =
          typename strategy_or_default<typename types::strategy, (sizeof...(Position) > 0)>::type;
      const inputs_view<Graph, Call> inputs{b, at, own};
      bool is_now = false;
      if constexpr (c.fast_clock.known()) {
        if (in_fast_run<typename as_planned<Graph>::type>::is_now(b)) is_now = ticks<c.fast_clock>(b.k);
        else CCA_INLINE_CALL is_now = strategy{}.fires(beat_of<Graph, Call>(b.k, own), inputs);
      } else if constexpr (!std::is_empty_v<strategy>) {
        strategy& kept = strategy_in<Graph, Call>(b.state);
        CCA_INLINE_CALL is_now = kept.fires(beat_of<Graph, Call>(b.k, own), inputs);
      } else {
        CCA_INLINE_CALL is_now = strategy{}.fires(beat_of<Graph, Call>(b.k, own), inputs);
      }
      if (!is_now) return {};
      if constexpr (c.stored_seen) own.oldest = oldest_seen();
      const std::int64_t last = own.last;
      const std::int64_t beats = beats_since<Graph, Call>(b.k, own);
      own.last = b.k;
      if constexpr (part >= 0) own.is_first = false;
      return {true, beats, last};
    } else {
      constexpr std::int64_t beats = c.own_clock.period;
      constexpr bool is_period = first_beats == beats;
      const bool is_now = ticks<c.own_clock>(b.k);
      if constexpr (c.unsteady || part >= 0) {
        // Before the switch to this mode it fired at other beats, or not at all; and its part may have
        // rested.
        const std::int64_t last_known = b.k - beats;
        const bool is_known = last_known >= known_since();
        if constexpr (runs_in_cycles<Graph> && c.unsteady) {
          const last_firing& kept = b.state.firings[at.firing];
          const bool goes_on = is_known || (kept.last == last_known && !kept.is_first);
          return {true, goes_on ? b.state.beats_since : 1, is_known ? last_known : kept.last};
        } else if constexpr (runs_in_cycles<Graph>) {
          const std::int64_t since = b.state.parts[array_size(part)].since;
          return {true, is_known ? b.state.beats_since : 1, is_known ? last_known : since - 1};
        } else if constexpr (!c.unsteady) {
          const std::int64_t since = b.state.parts[array_size(part)].since;
          return {is_now, is_known || is_period ? beats : 1, is_known ? last_known : since - 1};
        } else {
          constexpr bool is_constant = beats == 1 && !c.other_clocks;
          const last_firing& kept = b.state.firings[at.firing];
          const std::int64_t last = is_known ? last_known : kept.last;
          const bool has_fired = last >= 0 && (part < 0 || is_known || !kept.is_first);
          return {is_now, !is_constant && has_fired ? b.k - last : is_period ? beats : 1, last};
        }
      } else {
        const bool is_first = b.k == c.own_clock.first;
        if constexpr (runs_in_cycles<Graph>) return {true, b.state.beats_since, is_first ? -1 : b.k - 1};
        return {is_now, is_period || !is_first ? beats : 1, is_first ? -1 : b.k - beats};
      }
    }
  }
  // Since it last fired, the first time.
  static constexpr std::int64_t first_beats = [] {
    const auto strategy = plan_of<Graph>.nodes[c.node].item->strategy_while_started();
    return c.own_clock.known() && strategy && strategy->first_dt_is_period ? c.own_clock.period : 1;
  }();
  // In a replay what was published arrives, whether its component rests meanwhile or not.
  CCA_INLINE bool is_played() const {
    return played_call<typename as_planned<Graph>::type, Call>::is_now(b.state);
  }
  CCA_INLINE std::int64_t this_beat() const {
    if constexpr (runs_in_cycles<Graph>) return b.state.beat;
    else return b.k;
  }
  // The first beat from which on its clock tells when it fired.
  CCA_INLINE std::int64_t known_since() const {
    std::int64_t since = c.own_clock.first;
    if constexpr (part >= 0) since = std::max(since, b.state.parts[array_size(part)].since);
    if constexpr (c.unsteady) since = std::max(since, b.state.since);
    return since;
  }

  // The arguments are made in place: a function in between would copy them.
  template <std::size_t... I>
  CCA_INLINE result call(const firing& now, std::index_sequence<I...>) const {
    using ports = function_ports<list<Parameters...>, list<>>;
    using all_if_derived = std::conditional_t<c.function->derives, list<Parameters...>, void>;
    [[maybe_unused]] const beat time = beat_of_seconds::make(this_beat(), period, now.dt);
    [[maybe_unused]] auto& self =
        component_in<Graph, layout_of<Graph>.components[c.node].array>(b.state, at.component);
    constexpr auto function = function_of<component, c.phase>::value;
    if constexpr (std::is_member_function_pointer_v<decltype(function)>)
      CCA_INLINE_CALL return (self.*simplified_first<function>())(
          argument<Graph, Parameters, input_shown(ports::source_of_parameter[I])>::template get<
              Parameters, all_if_derived>(b, source(ports::source_of_parameter[I]), time, now.last)...);
    else
      CCA_INLINE_CALL return simplified_first<function>()(
          argument<Graph, Parameters, input_shown(ports::source_of_parameter[I])>::template get<
              Parameters, all_if_derived>(b, source(ports::source_of_parameter[I]), time, now.last)...);
  }
  // The number of the input at a position: the first that reads in the same way; -1 for a beat.
  static constexpr int input_shown(int position) {
    return position < 0 ? -1 : layout_of<Graph>.input_twin[c.first_input + position];
  }
  template <int P>
  using reader = input_reader<Graph, input_shown(P)>;
  CCA_INLINE int source(int position) const {
    return position < 0 ? -1 : index_of_source<Graph>(at, position);
  }

  CCA_INLINE void take_from_queues() const {
    if constexpr (has_queue<Graph>(c)) (take<Position>(), ...);
    if constexpr (has_observers(c)) take_heard<Graph, Call>(b);
  }
  template <int P>
  CCA_INLINE void take() const {
    if constexpr (constexpr int output = output_of_taken<Graph, Call, P>; output >= 0) {
      const auto& waiting = reader<P>::stored(b, source(P));
      if (!played_taken<typename as_planned<Graph>::type, output>::is_told(b) && !waiting.is_empty())
        publish_taken<Graph, output>(b, waiting.show()->vector(), waiting.show()->origin());
    }
    reader<P>::take(b, source(P));
  }

  // Where the readers of this beat find the result; if there are none, in a variable of this call.
  CCA_INLINE void* place_of_result([[maybe_unused]] result_of_beat<result, true>& unread) const {
    constexpr int array = layout_of<Graph>.results[Call].array;
    if constexpr (array >= 0) return b.template at<array>(at.result).place();
    else return unread.place();
  }

  // The oldest origin among the inputs as they were; if none counts, the beat's time. If the compiler knows
  // that a sample has arrived, the beat does not test it: in a chain each test would wait for the one before.
  CCA_INLINE std::int64_t origin() const {
    const std::int64_t time = this_beat() * period;
    if constexpr (c.phase == phase_of_beat::sense) {
      return time;
    } else {
      constexpr bool is_known = (reader<Position>::has_surely_arrived || ...);
      std::int64_t oldest = is_known ? std::numeric_limits<std::int64_t>::max() : never;
      (reader<Position>::add_origin(oldest, b, source(Position)), ...);
      if constexpr (has_observers(c)) oldest = oldest_heard<Graph, Call>(b, oldest);
      if constexpr (!is_known)
        if (oldest == never) oldest = time;
      return oldest;
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
    if constexpr (is_wired<Graph, input_shown(P)>) {
      const std::int64_t one = reader<P>::origin(b, source(P));
      oldest = one < oldest ? one : oldest;
    }
  }
};

template <class Graph, int Call>
using component_call = component_call_of<Graph,
                                         Call,
                                         typename function_called<Graph, Call>::parameters,
                                         typename function_called<Graph, Call>::results,
                                         input_positions<Graph, Call>,
                                         result_numbers<typename function_called<Graph, Call>::results>>;

}  // namespace cca::detail
