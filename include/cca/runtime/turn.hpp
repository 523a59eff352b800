// The turn of one function in a beat: whether it fires, what it sees, the call, and what it publishes.
#pragma once

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
  CCA_GLUE static Parameter get(memory<Graph>& m, const locals<Graph>& l, const beat& now, std::int64_t last) {
    Parameter port{to_be_filled{}};
    fill_port<Graph, Input>(port, see<Graph, Input>(m, l, now.index()), last);
    return port;
  }
};
template <class Graph, int Turn, int Input>
struct argument<Graph, Turn, Input, beat> {
  CCA_GLUE static beat get(memory<Graph>&, const locals<Graph>&, const beat& now, std::int64_t) { return now; }
};
template <class Graph, int Turn, int Input, fixed_string Scope, class Policy>
struct argument<Graph, Turn, Input, observe<Scope, Policy>> {
  using storage = decltype(observed<Graph, Input>(std::declval<memory<Graph>&>(), 0, 0));
  struct listening {
    storage all;
    operator observe<Scope, Policy>() const { return {all.entries.data(), static_cast<std::size_t>(all.count)}; }
  };
  CCA_GLUE static listening get(memory<Graph>& m, const locals<Graph>&, const beat& now, std::int64_t last) {
    return {observed<Graph, Input>(m, now.index(), last)};
  }
};

template <phase_of_beat Phase, class Component, class... Arguments>
CCA_GLUE decltype(auto) call(Component& component, Arguments&&... arguments) {
  if constexpr (Phase == phase_of_beat::process) CCA_INLINE_CALL return component.process(static_cast<Arguments&&>(arguments)...);
  else if constexpr (Phase == phase_of_beat::sense) CCA_INLINE_CALL return component.sense(static_cast<Arguments&&>(arguments)...);
  else CCA_INLINE_CALL return component.act(static_cast<Arguments&&>(arguments)...);
}

// Queues show what was taken. An input that does not count leaves the oldest as it is.
template <class Graph, int Input>
CCA_GLUE void add_origin(std::int64_t& oldest, const memory<Graph>& m, const locals<Graph>& l, std::int64_t k) {
  constexpr const auto& in = input_of<Graph, Input>;
  if constexpr (in.writer >= 0 && in.counts) {
    if constexpr (in.queue >= 0) oldest = older(oldest, static_cast<const waiting_samples<Graph, Input>&>(m).taken.origin);
    else oldest = older(oldest, hold<Graph, Input>(m, l, k).origin);
  }
}

// The oldest origin among the inputs as they were; the beat's time where none counts.
template <class Graph, int Turn, int... Input>
CCA_GLUE std::int64_t oldest_origin(const memory<Graph>& m, const locals<Graph>& l, const beat& now, std::integer_sequence<int, Input...>) {
  std::int64_t oldest = never;
  (add_origin<Graph, Input>(oldest, m, l, now.index()), ...);
  for_each_observed<Graph, Turn>([&]<int Link>() { oldest = older(oldest, observe_one<Graph, Link>(m, now.index()).origin); });
  return oldest == never ? now.time() : oldest;
}

template <class Graph, int Input, class Value>
CCA_GLUE void push(waiting_samples<Graph, Input>& q, course& course, const Value& value, std::int64_t origin) {
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
  auto& place = q.ring[static_cast<std::size_t>(at < q.capacity ? at : at - q.capacity)];
  copy_coordinates<size_of_input<Graph, Input>>(place.value, value);
  place.origin = origin;
  ++q.count;
}

// Into the queues among the readers of an output, from reader `Input` on.
template <class Graph, int Input, class Value>
CCA_GLUE void push_to_queues(memory<Graph>& m, course& course, const Value& value, std::int64_t origin) {
  if constexpr (Input >= 0) {
    if constexpr (input_of<Graph, Input>.queue >= 0) push<Graph, Input>(m, course, value, origin);
    push_to_queues<Graph, input_of<Graph, Input>.next_of_writer>(m, course, value, origin);
  }
}

template <int Size, class Sample, class Value>
CCA_GLUE void store(Sample& to, const Value& value, std::int64_t origin) {
  copy_coordinates<Size>(to.value, value);
  to.origin = origin;
}

template <class Graph, int Output, class Result>
CCA_GLUE void publish(const Result& result, memory<Graph>& m, locals<Graph>& l, course& course, std::int64_t k, std::int64_t oldest) {
  constexpr const auto& out = output_of<Graph, Output>;
  if constexpr (requires { result.operator bool(); })
    if (!result) return;
  const std::int64_t origin = result.origin() == never ? oldest : result.origin();
  const auto& value = result.vector();
  if constexpr (out.local) {
    local_sample<Graph, Output>& s = l;
    store<size_of_output<Graph, Output>>(s, value, origin);
    if constexpr (!is_sure<Graph, Output>) s.published = true;
  }
  if constexpr (out.kept) {
    kept_sample<Graph, Output>& s = m;
    store<size_of_output<Graph, Output>>(s, value, origin);
    if constexpr (out.stamped) s.when = k;
  }
  if constexpr (out.ring > 0) {
    past_samples<Graph, Output>& past = m;
    constexpr auto c = published_of<Graph, Output>;
    std::int64_t at;
    if constexpr (c.known()) at = (k - c.first) / c.period;
    else at = past.count++;
    auto& entry = past.entries[static_cast<std::size_t>(at) & static_cast<std::size_t>(past.size - 1)];
    store<size_of_output<Graph, Output>>(entry, value, origin);
    entry.when = k;
  }
  push_to_queues<Graph, out.first_reader>(m, course, value, origin);
}

template <class Graph, int Turn, class Results>
struct publishing;
template <class Graph, int Turn, class... Results>
struct publishing<Graph, Turn, list<Results...>> {
  using facts = half_facts<list<>, list<Results...>>;
  static constexpr const auto& t = turn_of<Graph, Turn>;

  template <int I, class Result>
  CCA_GLUE static void one(const Result& result, memory<Graph>& m, locals<Graph>& l, course& course, std::int64_t k, std::int64_t oldest) {
    if constexpr (std::is_same_v<Result, fault>) {
      if (result) course = {result.reason(), t.leaf};
    } else {
      publish<Graph, t.first_output + facts::output_of_result[I]>(result, m, l, course, k, oldest);
    }
  }

  CCA_GLUE static void all(const auto& result, memory<Graph>& m, locals<Graph>& l, course& course, std::int64_t k, std::int64_t oldest) {
    if constexpr (requires { std::tuple_size<std::remove_cvref_t<decltype(result)>>::value; }) {
      [&]<int... I>(std::integer_sequence<int, I...>) {
        (one<I>(std::get<I>(result), m, l, course, k, oldest), ...);
      }(std::make_integer_sequence<int, sizeof...(Results)>{});
    } else {
      one<0>(result, m, l, course, k, oldest);
    }
  }
};

template <class Graph, int Turn, class Parameters>
struct firing;
template <class Graph, int Turn, class... Parameters>
struct firing<Graph, Turn, list<Parameters...>> {
  static constexpr const auto& t = turn_of<Graph, Turn>;
  using component = typename leaf_of<Graph, t.leaf>::component;
  using function = function_facts<typename function_of<component, t.phase>::type>;
  using facts = half_facts<list<Parameters...>, list<>>;

  template <int... I>
  CCA_GLUE static void run(memory<Graph>& m, locals<Graph>& l, course& course, const beat& now, std::int64_t last, std::integer_sequence<int, I...>) {
    auto& self = static_cast<cell<Graph, t.leaf>&>(m).component;
    if constexpr (std::is_void_v<typename function::result>) {
      call<t.phase>(self, argument<Graph, Turn, t.first_input + facts::input_of_parameter[I], Parameters>::get(m, l, now, last)...);
      take_all(m, inputs_of<Graph, Turn>{});
    } else {
      const typename function::result result =
          call<t.phase>(self, argument<Graph, Turn, t.first_input + facts::input_of_parameter[I], Parameters>::get(m, l, now, last)...);
      take_all(m, inputs_of<Graph, Turn>{});
      std::int64_t oldest = now.time();
      if constexpr (t.phase != phase_of_beat::sense) oldest = oldest_origin<Graph, Turn>(m, l, now, inputs_of<Graph, Turn>{});
      publishing<Graph, Turn, typename function::results>::all(result, m, l, course, now.index(), oldest);
    }
  }

  template <int... Input>
  CCA_GLUE static void take_all(memory<Graph>& m, std::integer_sequence<int, Input...>) {
    (take_one<Input>(m), ...);
  }
  template <int Input>
  CCA_GLUE static void take_one(memory<Graph>& m) {
    if constexpr (input_of<Graph, Input>.queue >= 0) take<Graph, Input>(m);
  }
};

// Beats since the last firing, where the clock is known.
template <class Graph, int Turn>
CCA_GLUE constexpr std::int64_t beats_since(std::int64_t k) {
  constexpr const auto& t = turn_of<Graph, Turn>;
  constexpr auto c = t.fires;
  constexpr bool is_timed = plan_of<Graph>.leaves[t.leaf].item->strategy->kind == strategy_kind::timed;
  if constexpr (c.period == 1 || is_timed) return c.period;
  else return k == c.first ? 1 : c.period;
}

// Initial values count here as what they are: of the lowest origin.
template <class Graph, int... Input>
CCA_GLUE std::int64_t oldest_seen(const memory<Graph>& m, const locals<Graph>& l, std::int64_t k, std::integer_sequence<int, Input...>) {
  std::int64_t oldest = std::numeric_limits<std::int64_t>::max();
  const auto one = [&](std::int64_t origin) { oldest = origin < oldest ? origin : oldest; };
  ((is_wired<Graph, Input> ? one(see<Graph, Input>(m, l, k).origin) : void()), ...);
  return oldest;
}

template <class Graph, int Turn>
CCA_GLUE void take_turn(memory<Graph>& m, locals<Graph>& l, course& course, std::int64_t k) {
  constexpr const auto& t = turn_of<Graph, Turn>;
  if constexpr (t.fires.never()) {
    return;
  } else {
    using leaf_facts = leaf_of<Graph, t.leaf>;
    using function = function_facts<typename function_of<typename leaf_facts::component, t.phase>::type>;
    using parameters = typename function::parameters;
    constexpr auto all = []<class... P>(list<P...>) { return std::make_integer_sequence<int, sizeof...(P)>{}; }(parameters{});
    constexpr std::int64_t period = counts_of<Graph>.period;
    if constexpr (t.fires.known()) {
      if (!ticks<t.fires>(k)) return;
      const std::int64_t last = k == t.fires.first ? -1 : k - t.fires.period;
      firing<Graph, Turn, parameters>::run(m, l, course, beat{k, period, beats_since<Graph, Turn>(k)}, last, all);
    } else {
      turn_memory<Graph, Turn>& self = m;
      using strategy = typename strategy_or_default<typename leaf_facts::strategy, (t.half->input_count > 0)>::type;
      if (!asking<strategy>::template fires<Graph, Turn>(question<Graph, Turn>{m, l, k, self})) return;
      if constexpr (t.stored_seen) {
        self.oldest = oldest_seen<Graph>(m, l, k, inputs_of<Graph, Turn>{});
      }
      const std::int64_t last = self.last;
      self.last = k;
      firing<Graph, Turn, parameters>::run(m, l, course, beat{k, period, last < 0 ? 1 : k - last}, last, all);
    }
  }
}

}  // namespace cca::detail
