// What a strategy sees of the inputs of its component, where it is asked at run time.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <tuple>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/messages/tell_names.hpp>
#include <cca/graph/plan/paths.hpp>
#include <cca/runtime/observe.hpp>

namespace cca::detail {

// Since it last fired. The first time it is one beat, or, of a part that was started, what its strategy says.
template <class Graph, int Call>
CCA_INLINE std::int64_t beats_since(std::int64_t k, const last_firing& self) {
  if constexpr (part_of_call_at<Graph, Call> >= 0) {
    constexpr auto strategy = plan_of<Graph>.nodes[call_of<Graph, Call>.node].item->strategy_while_started();
    constexpr bool is_period = strategy && strategy->first_dt_is_period && strategy->alone.known();
    if (self.is_first) return is_period ? strategy->alone.period : 1;
  }
  return self.last < 0 ? 1 : k - self.last;
}
template <class Graph, int Call>
CCA_INLINE beat beat_of(std::int64_t k, const last_firing& self) {
  return {k, counts_of<Graph>.period, beats_since<Graph, Call>(k, self)};
}

template <class Graph, int Call, class Component, fixed_string Input>
struct unknown_input_read {
  static constexpr void tell(text& m) {
    const function_info& function = *call_of<Graph, Call>.function;
    std::array<std::string_view, 64> names{};
    std::size_t count = 0;
    for (int p = 0; p < function.input_count && count < names.size(); ++p)
      names[count++] = function.inputs[p].name;
    m << "strategy.unknown_port: the strategy of the node `";
    add_node_path(m, plan_of<Graph>.view(), call_of<Graph, Call>.node);
    m << "` reads the input `" << Input.view() << "`, which its component, " << type_name<Component>()
      << ", lacks";
    tell_names(m, Input.view(), std::span(names.data(), count));
  }
};

// What a strategy is given of a call's inputs. component/strategy.hpp says what each function is.
template <class Graph, int Call, class Positions = input_positions<Graph, Call>>
struct inputs_view;
template <class Graph, int Call, int... Position>
struct inputs_view<Graph, Call, std::integer_sequence<int, Position...>> {
  const beat_context<Graph>& b;
  const call_place& at;
  const last_firing& self;

  CCA_INLINE bool any_fresh() const { return (is_fresh<Position>() || ... || any_observed()); }
  CCA_INLINE bool all_fresh() const {
    return ((!is_wired<Graph, input_at<Graph, Call, Position>> || is_fresh<Position>()) && ... &&
            (!has_observers(call_of<Graph, Call>) || any_observed()));
  }
  // All inputs hold arrived samples of one origin, later than what was seen in the last firing.
  CCA_INLINE bool share_new_origin() const {
    std::int64_t common = never;
    bool all = true;
    (join<Position>(common, all), ...);
    return all && common > self.oldest;
  }
  // Or since beat 0, or since its part was started.
  CCA_INLINE std::int64_t beats_since_fired() const {
    if constexpr (part_of_call_at<Graph, Call> >= 0)
      if (self.is_first) return b.k - self.last - 1;
    return b.k - (self.last < 0 ? 0 : self.last);
  }
  // It is asked only while its part is started.
  CCA_INLINE static constexpr bool is_stopped() { return false; }

  template <fixed_string Name>
  CCA_INLINE bool fresh() const {
    return is_fresh<position_of<Name>()>();
  }
  // How many samples wait in its queue; without one: 1 if it is fresh.
  template <fixed_string Name>
  CCA_INLINE int waiting() const {
    return waiting_at<position_of<Name>()>();
  }
  // How many samples have arrived in this beat.
  template <fixed_string Name>
  CCA_INLINE int arrivals() const {
    return arrived_at<position_of<Name>()>();
  }
  template <fixed_string Name>
  auto get() const {
    using function = typename function_of<component, call_of<Graph, Call>.phase>::type;
    return filled<position_of<Name>()>(typename function_facts<function>::parameters{});
  }

private:
  using component = typename node_types<Graph, call_of<Graph, Call>.node>::component;

  template <int Input>
  CCA_INLINE bool is_fresh() const {
    constexpr int input = input_at<Graph, Call, Input>;
    if constexpr (is_wired<Graph, input>)
      return input_reader<Graph, input>::is_fresh(b, index_of_source<Graph>(at, Input), self.last);
    else return false;
  }
  template <int Input>
  CCA_INLINE int waiting_at() const {
    using reader = input_reader<Graph, input_at<Graph, Call, Input>>;
    if constexpr (reader::kind == storage_kind::queue) return reader::stored(b, index_of<Input>()).waiting();
    else return is_fresh<Input>();
  }
  template <int Input>
  CCA_INLINE int arrived_at() const {
    constexpr int input = input_at<Graph, Call, Input>;
    using reader = input_reader<Graph, input>;
    if constexpr (reader::kind == storage_kind::queue) {
      static_assert(input_of<Graph, input>.counts_arrivals,
                    "cca::ProcessingStrategy: this strategy asks how many samples have arrived in a queue, "
                    "but does not say so: give it `static constexpr bool counts_arrivals = true;`");
      return reader::stored(b, index_of<Input>()).arrivals(b.k);
    } else if constexpr (is_wired<Graph, input>) {
      return reader::arrived(b, index_of<Input>()) == b.k;
    } else {
      return 0;
    }
  }
  template <int Input>
  CCA_INLINE int index_of() const {
    return index_of_source<Graph>(at, Input);
  }
  template <int Input>
  CCA_INLINE void join(std::int64_t& common, bool& all) const {
    constexpr int input = input_at<Graph, Call, Input>;
    if constexpr (is_wired<Graph, input>) {
      const auto origin = input_reader<Graph, input>::origin(b, index_of_source<Graph>(at, Input));
      if (common == never) common = origin;
      all = all && origin != never && origin == common;
    }
  }
  // Does an observer of this function listen to something fresh?
  CCA_INLINE bool any_observed() const {
    bool any = false;
    if constexpr (has_observers(call_of<Graph, Call>))
      for_each_observed<Graph, Call>(
          [&]<int Link>() { any = any || observed_sample<Graph, Link>::is_fresh(b, self.last); });
    return any;
  }

  // The position of an input among those of its function.
  template <fixed_string Name>
  static consteval int position_of() {
    constexpr int position = [] {
      const function_info& function = *call_of<Graph, Call>.function;
      for (int p = 0; p < function.input_count; ++p)
        if (function.inputs[p].name == Name.view()) return p;
      return -1;
    }();
    static_assert(holds_or_tells<(position >= 0), unknown_input_read<Graph, Call, component, Name>>::value);
    return position < 0 ? 0 : position;  // the message says the rest
  }

  template <int Input, class... Parameters>
  auto filled(list<Parameters...>) const {
    constexpr int parameter = [] {
      const auto& positions = function_ports<list<Parameters...>, list<>>::input_of_parameter;
      for (std::size_t i = 0; i < sizeof...(Parameters); ++i)
        if (positions[i] == Input) return static_cast<int>(i);
      return 0;
    }();
    using port = std::tuple_element_t<static_cast<std::size_t>(parameter), std::tuple<Parameters...>>;
    return input_reader<Graph, input_at<Graph, Call, Input>>::template get<port>(
        b, index_of_source<Graph>(at, Input), beat_of<Graph, Call>(b.k, self), self.last);
  }
};

}  // namespace cca::detail
