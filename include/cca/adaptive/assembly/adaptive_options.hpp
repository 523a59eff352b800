// The options of an adaptive component: names of ports, target, mappings on its ports (adaptive_component.hpp
// describes each).
#pragma once

#include <cca/adaptive/criterion.hpp>
#include <cca/component/strategies.hpp>
#include <cca/graph/items/inner_wires.hpp>

namespace cca {

template <fixed_string Reference, fixed_string Command, fixed_string OdeStatus>
struct named {};
template <criterion_target Target>
struct against {};
template <class Mapping>
struct reference_through {};
template <class Mapping>
struct feedback_through {};
template <class Mapping>
struct command_through {};
template <fixed_string Input, class Mapping>
struct control_through {};

namespace detail {

// Each of these finds one option in the list, or its default.
template <template <class> class Kind, class... Options>
struct mapping_option {
  using type = void;
};
template <template <class> class Kind, class Mapping, class... Rest>
struct mapping_option<Kind, Kind<Mapping>, Rest...> {
  using type = Mapping;
};
template <template <class> class Kind, class Other, class... Rest>
struct mapping_option<Kind, Other, Rest...> : mapping_option<Kind, Rest...> {};

template <fixed_string Input, class... Options>
struct control_option {
  using type = void;
};
template <fixed_string Input, class Mapping, class... Rest>
struct control_option<Input, control_through<Input, Mapping>, Rest...> {
  using type = Mapping;
};
template <fixed_string Input, class Other, class... Rest>
struct control_option<Input, Other, Rest...> : control_option<Input, Rest...> {};

template <class Type> concept StatesStrategy = requires { &Type::template fires<any_inputs>; };

template <class... Options>
struct strategy_option {
  using type = timed<1>;
};
template <StatesStrategy First, class... Rest>
struct strategy_option<First, Rest...> {
  using type = First;
};
template <class First, class... Rest>
struct strategy_option<First, Rest...> : strategy_option<Rest...> {};

template <class... Options>
struct names_option {
  using type = named<"reference", "command", "ode">;
};
template <fixed_string Reference, fixed_string Command, fixed_string OdeStatus, class... Rest>
struct names_option<named<Reference, Command, OdeStatus>, Rest...> {
  using type = named<Reference, Command, OdeStatus>;
};
template <class First, class... Rest>
struct names_option<First, Rest...> : names_option<Rest...> {};

template <criterion_target Default, class... Options>
inline constexpr criterion_target target_option = Default;
template <criterion_target Default, criterion_target Target, class... Rest>
inline constexpr criterion_target target_option<Default, against<Target>, Rest...> = Target;
template <criterion_target Default, class First, class... Rest>
inline constexpr criterion_target target_option<Default, First, Rest...> = target_option<Default, Rest...>;

template <class Type>
constexpr bool is_component_option = StatesStrategy<Type>;
template <fixed_string A, fixed_string B, fixed_string C>
constexpr bool is_component_option<named<A, B, C>> = true;
template <criterion_target Target>
constexpr bool is_component_option<against<Target>> = true;
template <class M>
constexpr bool is_component_option<reference_through<M>> = true;
template <class M>
constexpr bool is_component_option<feedback_through<M>> = true;
template <class M>
constexpr bool is_component_option<command_through<M>> = true;
template <fixed_string Input, class M>
constexpr bool is_component_option<control_through<Input, M>> = true;

template <class... Policies>
constexpr bool is_component_option<inner_wires<Policies...>> = true;

template <class Type> concept ComponentOption = is_component_option<Type>;

}  // namespace detail
}  // namespace cca
