// What may be said of an adaptive component: names, target, mappings on its ports (adaptive_component.hpp
// says what each does).
#pragma once

#include <cca/adaptive/criterion.hpp>
#include <cca/component/strategy.hpp>

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

// The options, one of each kind.
template <template <class> class Kind, class... Options>
struct mapping_among {
  using type = void;
};
template <template <class> class Kind, class Mapping, class... Rest>
struct mapping_among<Kind, Kind<Mapping>, Rest...> {
  using type = Mapping;
};
template <template <class> class Kind, class Other, class... Rest>
struct mapping_among<Kind, Other, Rest...> : mapping_among<Kind, Rest...> {};

template <fixed_string Input, class... Options>
struct control_among {
  using type = void;
};
template <fixed_string Input, class Mapping, class... Rest>
struct control_among<Input, control_through<Input, Mapping>, Rest...> {
  using type = Mapping;
};
template <fixed_string Input, class Other, class... Rest>
struct control_among<Input, Other, Rest...> : control_among<Input, Rest...> {};

template <class Type> concept StatesStrategy =
    strategy_of<Type>.kind != strategy_kind::user || requires { &Type::template fires<any_inputs>; };

template <class... Options>
struct strategy_among {
  using type = timed<1>;
};
template <StatesStrategy First, class... Rest>
struct strategy_among<First, Rest...> {
  using type = First;
};
template <class First, class... Rest>
struct strategy_among<First, Rest...> : strategy_among<Rest...> {};

template <class... Options>
struct names_among {
  using type = named<"reference", "command", "ode">;
};
template <fixed_string Reference, fixed_string Command, fixed_string OdeStatus, class... Rest>
struct names_among<named<Reference, Command, OdeStatus>, Rest...> {
  using type = named<Reference, Command, OdeStatus>;
};
template <class First, class... Rest>
struct names_among<First, Rest...> : names_among<Rest...> {};

template <criterion_target Default, class... Options>
inline constexpr criterion_target target_among = Default;
template <criterion_target Default, criterion_target Target, class... Rest>
inline constexpr criterion_target target_among<Default, against<Target>, Rest...> = Target;
template <criterion_target Default, class First, class... Rest>
inline constexpr criterion_target target_among<Default, First, Rest...> = target_among<Default, Rest...>;

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

template <class Type> concept ComponentOption = is_component_option<Type>;

}  // namespace detail
}  // namespace cca
