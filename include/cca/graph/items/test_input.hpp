// cca::test_input: an input of a component to which a test adds a signal while the graph runs.
//
//   struct axis : cca::graph<cca::rate<1000>,
//                            cca::node<"servo", cca::pid<angles, torques>>,
//                            cca::wire<"plan.angles", "servo.reference">, ...
//                            cca::test_input<"servo.reference", cca::up_to<0.1>>> {};  // at most 0.1 rad
//
// Without an `up_to` the largest amplitude is half the narrowest range of the axes. The declaration puts a
// node between the input and what is wired to it, here `test_servo_reference`:
// component/testing/test_node.hpp has its ports and parameters, docs/tuning.md says how to use it. The signal
// is off until a test begins.
//
// A delay stays before the node, a queue after it: all else is as if the node were not there. Where no
// limiter comes after the input, the rule robot.unlimited_command refuses the graph, because the sum is not
// limited. In a deployment the node is placed as any other; where the input is.
//
// Errors: graph.bad_test_input. Cost: that of the node. A graph without one is as it ever was.
// Tests: tests/runtime/core/test_input.cpp.
#pragma once

#include <cstddef>
#include <string_view>
#include <type_traits>

#include <cca/base/fixed_string.hpp>
#include <cca/base/joined_names.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/component/testing/test_node.hpp>
#include <cca/graph/items/graph.hpp>

namespace cca {

template <fixed_string Input, class Range = detail::by_limits>
struct test_input {};

namespace detail {

template <fixed_string Input, class Range>
inline constexpr bool is_test_input<test_input<Input, Range>> = true;

// ---- names ----

// Of `servo.reference` `test_servo_reference`.
template <fixed_string Input>
consteval auto name_as_test() {
  constexpr std::string_view before = "test_";
  char all[sizeof(Input.text) + before.size()]{};
  std::size_t end = 0;
  for (const char c : before) all[end++] = c;
  for (const char c : Input.view()) all[end++] = c == '.' ? '_' : c;
  return fixed_string(all);
}
template <fixed_string Input>
inline constexpr auto name_of_test = name_as_test<Input>();
// ---- the node whose input it is ----

struct no_such_node {};
template <fixed_string Name, class... Items>
struct component_named {
  using type = no_such_node;
};
template <fixed_string Name, class First, class... Rest>
struct component_named<Name, First, Rest...> : component_named<Name, Rest...> {};
template <fixed_string Name, fixed_string Its, class Component, class Strategy, class... Rest>
struct component_named<Name, node<Its, Component, Strategy>, Rest...>
    : std::conditional_t<Name.view() == Its.view(),
                         std::type_identity<Component>,
                         component_named<Name, Rest...>> {};

template <fixed_string Input>
struct test_of_unknown_node {
  static constexpr void tell(text& m) {
    m << "graph.bad_test_input: `" << Input.view()
      << "` of a cca::test_input is no input of a node of this graph: write it as in a wire, `node.port`";
  }
};
template <fixed_string Input>
struct test_of_unwired {
  static constexpr void tell(text& m) {
    m << "graph.bad_test_input: nothing is wired to `" << Input.view()
      << "`, which a cca::test_input names: a test adds to what the input gets: wire it, or expose it";
  }
};
template <fixed_string Input>
struct test_of_merged {
  static constexpr void tell(text& m) {
    m << "graph.bad_test_input: several wires are merged at `" << Input.view()
      << "`, which a cca::test_input names: a test needs an input with one writer";
  }
};
template <fixed_string Input>
struct test_twice {
  static constexpr void tell(text& m) {
    m << "graph.bad_test_input: two cca::test_input name `" << Input.view() << "`: leave one out";
  }
};

// ---- ends of wires ----

template <fixed_string Input, class Item>
inline constexpr bool leads_to = false;
template <fixed_string Input, fixed_string From, fixed_string To, class... Options>
inline constexpr bool leads_to<Input, wire<From, To, Options...>> = Input.view() == To.view();
template <fixed_string Input, fixed_string Inner, fixed_string Outer>
inline constexpr bool leads_to<Input, expose<Inner, Outer>> = Input.view() == Inner.view();
template <fixed_string Input, class Item>
inline constexpr bool tests_it = false;
template <fixed_string Input, class Range>
inline constexpr bool tests_it<Input, test_input<Input, Range>> = true;

template <class Option>
inline constexpr bool is_merged_option = false;
template <int Capacity, class Full>
inline constexpr bool is_merged_option<merged<Capacity, Full>> = true;
template <class Item>
inline constexpr bool is_merged_wire = false;
template <fixed_string From, fixed_string To, class... Options>
inline constexpr bool is_merged_wire<wire<From, To, Options...>> = (is_merged_option<Options> || ...);

// What is said of the samples on their way, and what the input itself does with them.
template <class Option>
inline constexpr bool stays_with_input = false;
template <int Capacity, class Full>
inline constexpr bool stays_with_input<queue<Capacity, Full>> = true;
template <auto... Coordinates>
inline constexpr bool stays_with_input<initial<Coordinates...>> = true;

template <class Option>
inline constexpr bool is_queue_option = false;
template <int Capacity, class Full>
inline constexpr bool is_queue_option<queue<Capacity, Full>> = true;
template <bool AtInput, class... Options>
using options_of_wire =
    typename joined<list<>,
                    std::conditional_t<stays_with_input<Options> == AtInput, list<Options>, list<>>...>::type;

// ---- the items of a graph with tests ----

// What is said of the input `Input`, judged by all items of the graph.
template <fixed_string Input, class... All>
struct test_of_input {
  using parts = parts_of_input<Input>;
  using component = typename component_named<parts::node, All...>::type;
  static constexpr bool has_node = !std::is_same_v<component, no_such_node>;
  static constexpr bool is_wired = is_any<leads_to<Input, All>...>;
  static constexpr bool is_merged = is_any<(leads_to<Input, All> && is_merged_wire<All>)...>;
  static constexpr bool is_twice = how_many<tests_it<Input, All>...> > 1;
  static constexpr bool is_right = has_node && is_wired && !is_merged && !is_twice;
  static_assert(holds_or_tells<has_node, test_of_unknown_node<Input>>::value);
  static_assert(holds_or_tells < !has_node || is_wired, test_of_unwired < Input >> ::value);
  static_assert(holds_or_tells<!is_merged, test_of_merged<Input>>::value);
  static_assert(holds_or_tells<!is_twice, test_twice<Input>>::value);
};

template <class Item, class... All>
struct item_with_tests {
  using type = list<Item>;
};
template <fixed_string Input, class Range, class... All>
struct item_with_tests<test_input<Input, Range>, All...> {
  using test = test_of_input<Input, All...>;
  static constexpr auto its_name = name_of_test<Input>;
  using type = std::conditional_t<test::is_right,
                                  list<node<its_name, test_node<Input, typename test::component, Range>>>,
                                  list<>>;
};

// A wire, or an `expose`, that leads to a tested input leads to its node, and another wire on from there.
// That node gives each sample on at once, so the rates of both ends say nothing new of each other: `latest`.
template <fixed_string Input, class Before, bool HasQueue, class... AtInput>
struct around_test {
  using after = wire<joined_name<name_of_test<Input>, "output">, Input, AtInput...>;
  using type = list<Before, after>;
};
template <fixed_string Input, class Before, class... AtInput>
struct around_test<Input, Before, false, AtInput...> {
  using after = wire<joined_name<name_of_test<Input>, "output">, Input, latest, AtInput...>;
  using type = list<Before, after>;
};
template <fixed_string Input, class Before, class AtInput>
struct around_test_with;
template <fixed_string Input, class Before, class... AtInput>
struct around_test_with<Input, Before, list<AtInput...>>
    : around_test<Input, Before, (is_queue_option<AtInput> || ...), AtInput...> {};

template <fixed_string From, fixed_string To, class Options>
struct wire_to_test;
template <fixed_string From, fixed_string To, class... Options>
struct wire_to_test<From, To, list<Options...>> {
  using type = wire<From, joined_name<name_of_test<To>, "input">, Options...>;
};

template <fixed_string From, fixed_string To, class... Options, class... All>
  requires(is_any<tests_it<To, All>...>)
struct item_with_tests<wire<From, To, Options...>, All...> {
  using before = typename wire_to_test<From, To, options_of_wire<false, Options...>>::type;
  using type =
      std::conditional_t<test_of_input<To, All...>::is_right,
                         typename around_test_with<To, before, options_of_wire<true, Options...>>::type,
                         list<wire<From, To, Options...>>>;
};
template <fixed_string Inner, fixed_string Outer, class... All>
  requires(is_any<tests_it<Inner, All>...>)
struct item_with_tests<expose<Inner, Outer>, All...> {
  using before = expose<joined_name<name_of_test<Inner>, "input">, Outer>;
  using type = std::conditional_t<test_of_input<Inner, All...>::is_right,
                                  typename around_test<Inner, before, false>::type,
                                  list<expose<Inner, Outer>>>;
};

template <class... Items>
struct items_of_graph<true, Items...> {
  using type = typename joined<list<>, typename item_with_tests<Items, Items...>::type...>::type;
};

}  // namespace detail
}  // namespace cca
