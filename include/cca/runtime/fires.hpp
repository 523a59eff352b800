// Whether a component fires in beat k: settled at compile time wherever its clock is known, else asked of its
// strategy.
#pragma once

#include <tuple>

#include <cca/graph/paths.hpp>
#include <cca/runtime/observe.hpp>

namespace cca::detail {

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

// The state of a function whose clock is known only at run time, when its strategy is asked.
template <class Graph, int Call>
struct question {
  const beat_context<Graph>& b;
  const call_place& at;
  const last_firing& self;

  template <int Position>
  CCA_INLINE bool fresh() const {
    constexpr int input = input_at<Graph, Call, Position>;
    if constexpr (is_wired<Graph, input>)
      return input_reader<Graph, input>::is_fresh(b, index_of_source<Graph>(at, Position), self.last);
    else return false;
  }
  template <int... Position>
  CCA_INLINE bool any_fresh(std::integer_sequence<int, Position...>) const {
    return (fresh<Position>() || ... || any_observed());
  }
  template <int... Position>
  CCA_INLINE bool all_fresh(std::integer_sequence<int, Position...>) const {
    return ((!is_wired<Graph, input_at<Graph, Call, Position>> || fresh<Position>()) && ... &&
            (!has_observers(call_of<Graph, Call>) || any_observed()));
  }

  // All inputs hold arrived samples of one origin, later than what was seen in the last firing.
  template <int... Position>
  CCA_INLINE bool together(std::integer_sequence<int, Position...>) const {
    std::int64_t common = never;
    bool all = true;
    (join<Position>(common, all), ...);
    return all && common > self.oldest;
  }
  template <int Position>
  CCA_INLINE void join(std::int64_t& common, bool& all) const {
    constexpr int input = input_at<Graph, Call, Position>;
    if constexpr (is_wired<Graph, input>) {
      const auto origin = input_reader<Graph, input>::origin(b, index_of_source<Graph>(at, Position));
      if (common == never) common = origin;
      all = all && origin != never && origin == common;
    }
  }

  // Does an observer of this function listen to something fresh?
  CCA_INLINE bool any_observed() const {
    bool any = false;
    if constexpr (has_observers(call_of<Graph, Call>))
      for_each_observed<Graph, Call>(
          [&]<int Link>() { any = any || observed_output<Graph, Link>::arrived(b) > self.last; });
    return any;
  }
};

template <class Graph, int Call>
CCA_INLINE beat beat_of(std::int64_t k, const last_firing& self) {
  return {k, counts_of<Graph>.period, self.last < 0 ? 1 : k - self.last};
}

// The path of a component, to be named by the compilers.
template <class Graph, int Node>
consteval auto path_of_node() {
  constexpr text path = [] {
    auto plan = plan_of<Graph>;
    text t;
    add_node_path(t, plan.view(), Node);
    return t;
  }();
  char letters[path.size + 1]{};
  for (std::size_t i = 0; i < path.size; ++i) letters[i] = path.letters[i];
  return fixed_string<path.size + 1>(letters);
}
template <fixed_string Node, class Component, fixed_string Input, bool HasInput>
constexpr auto check_input() {
  static_assert(HasInput,
                "strategy.unknown_port: the strategy of this node looks at an input by a name that its "
                "component has no input of (the compiler names "
                "the node, the component and the input); look at one that the component has, or give the "
                "node another strategy");
}

// What a user's strategy looks at.
template <class Graph, int Call>
struct inputs_view {
  const question<Graph, Call>& asked;

  template <fixed_string Name>
  auto get() const {
    using function = typename function_of<typename node_types<Graph, call_of<Graph, Call>.node>::component,
                                          call_of<Graph, Call>.phase>::type;
    return find<Name>(typename function_facts<function>::parameters{});
  }

private:
  template <fixed_string Name, class... Parameters>
  auto find(list<Parameters...>) const {
    constexpr int position = [] {
      const function_info& function = *call_of<Graph, Call>.function;
      for (int p = 0; p < function.input_count; ++p)
        if (function.inputs[p].name == Name.view()) return p;
      return -1;
    }();
    if constexpr (position < 0)
      check_input<path_of_node<Graph, call_of<Graph, Call>.node>(),
                  typename node_types<Graph, call_of<Graph, Call>.node>::component, Name, false>();
    constexpr int parameter = [] {
      const auto& positions = function_ports<list<Parameters...>, list<>>::input_of_parameter;
      for (std::size_t i = 0; i < sizeof...(Parameters); ++i)
        if (positions[i] == position) return static_cast<int>(i);
      return 0;
    }();
    constexpr int input = position < 0 ? 0 : position;  // the message says the rest
    using port = std::tuple_element_t<static_cast<std::size_t>(parameter), std::tuple<Parameters...>>;
    return input_reader<Graph, input_at<Graph, Call, input>>::template port<port>(
        asked.b, index_of_source<Graph>(asked.at, input), asked.self.last);
  }
};

template <class Strategy>
struct asking {
  template <class Graph, int Call>
  CCA_INLINE static bool fires(const question<Graph, Call>& q) {
    return Strategy{}.fires(beat_of<Graph, Call>(q.b.k, q.self), inputs_view<Graph, Call>{q});
  }
};

template <std::int64_t N, std::int64_t Phase>
struct asking<timed<N, Phase>> {
  template <class Graph, int Call>
  CCA_INLINE static bool fires(const question<Graph, Call>& q) {
    return ticks<clock_of_strategy(strategy_of<timed<N, Phase>>)>(q.b.k);
  }
};

template <>
struct asking<full_speed> {
  template <class Graph, int Call>
  CCA_INLINE static bool fires(const question<Graph, Call>&) {
    return true;
  }
};

template <>
struct asking<inactive> {
  template <class Graph, int Call>
  CCA_INLINE static bool fires(const question<Graph, Call>&) {
    return false;
  }
};

template <>
struct asking<restless> {
  template <class Graph, int Call>
  CCA_INLINE static bool fires(const question<Graph, Call>& q) {
    return q.any_fresh(input_positions<Graph, Call>{});
  }
};

template <>
struct asking<moderate> {
  template <class Graph, int Call>
  CCA_INLINE static bool fires(const question<Graph, Call>& q) {
    return q.all_fresh(input_positions<Graph, Call>{});
  }
};

template <fixed_string... Names>
struct asking<port_triggered<Names...>> {
  template <class Graph, int Call>
  CCA_INLINE static bool fires(const question<Graph, Call>& q) {
    return any_named(q, input_positions<Graph, Call>{});
  }
  template <class Graph, int Call, int... Position>
  CCA_INLINE static bool any_named(const question<Graph, Call>& q, std::integer_sequence<int, Position...>) {
    return (
        (is_named(call_of<Graph, Call>.function->inputs[Position].name) && q.template fresh<Position>()) ||
        ...);
  }
  static constexpr bool is_named(std::string_view name) { return ((name == Names.view()) || ...); }
};

template <std::int64_t N>
struct asking<timeout<N>> {
  template <class Graph, int Call>
  CCA_INLINE static bool fires(const question<Graph, Call>& q) {
    return q.b.k - (q.self.last < 0 ? 0 : q.self.last) >= N;
  }
};

template <>
struct asking<coordinated> {
  template <class Graph, int Call>
  CCA_INLINE static bool fires(const question<Graph, Call>& q) {
    return q.together(input_positions<Graph, Call>{});
  }
};

template <class... Strategies>
struct asking<any_of<Strategies...>> {
  template <class Graph, int Call>
  CCA_INLINE static bool fires(const question<Graph, Call>& q) {
    return (asking<Strategies>::template fires<Graph, Call>(q) || ...);
  }
};

template <class... Strategies>
struct asking<all_of<Strategies...>> {
  template <class Graph, int Call>
  CCA_INLINE static bool fires(const question<Graph, Call>& q) {
    return (asking<Strategies>::template fires<Graph, Call>(q) && ...);
  }
};

}  // namespace cca::detail
