// The interface of a component, read from the type of its `process` (of a resource node: `sense` and `act`).
// `ports_of_function<F>` has the inputs and outputs of a function F; its `value` is the same as data.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <cca/base/array_size.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/done.hpp>
#include <cca/component/fault.hpp>
#include <cca/component/port.hpp>
#include <cca/component/ports/derived.hpp>
#include <cca/component/switch_to.hpp>
#include <cca/base/ref.hpp>
#include <cca/space/info.hpp>

namespace cca::detail {

template <class...>
struct list {};
template <class... Lists>
struct joined;
template <class... A>
struct joined<list<A...>> {
  using type = list<A...>;
};
template <class... A, class... B, class... Rest>
struct joined<list<A...>, list<B...>, Rest...> : joined<list<A..., B...>, Rest...> {};

// How many of a list of conditions hold. A fold over them has at most 256 operands (docs/compilers.md), and
// a graph may have more items.
template <bool... Each>
inline constexpr int how_many = [] {
  constexpr bool each[] = {Each..., false};
  int count = 0;
  for (const bool holds : each) count += holds;
  return count;
}();
template <bool... Each>
inline constexpr bool is_any = how_many<Each...> != 0;

struct item_info;

struct port_info {
  std::string_view name{};
  ref<space_info> space = nullptr;  // none for an observer, which reads any space
  bool optional = false;
  bool maybe = false;
  const item_info& (*policy)() = nullptr;  // of an observer, as on a wire
};

// What a parameter of the function is.
enum class parameter_kind : std::uint8_t { input, derived, beat, bad };

template <class Type>
struct parameter_facts {
  static constexpr auto kind = parameter_kind::bad;
  static constexpr port_info port{};
};
template <>
struct parameter_facts<beat> {
  static constexpr auto kind = parameter_kind::beat;
  static constexpr port_info port{};
};
template <fixed_string Name, class Space>
struct parameter_facts<in<Name, Space>> {
  static constexpr auto kind = parameter_kind::input;
  static constexpr port_info port{Name.view(), &space_of<checked_space<Space>>};
};
template <fixed_string Name, class Space>
struct parameter_facts<optional_in<Name, Space>> {
  static constexpr auto kind = parameter_kind::input;
  static constexpr port_info port{Name.view(), &space_of<checked_space<Space>>, true};
};

// The policies of an observer as those of a wire. What they are is said with the items of a graph.
template <class... Policies>
constexpr const item_info& observer_policy();

template <fixed_string Scope, class... Policies>
struct parameter_facts<observe<Scope, Policies...>> {
  static constexpr auto kind = parameter_kind::input;
  static constexpr port_info port{Scope.view(), nullptr, true, false, &observer_policy<Policies...>};
};

template <class Function, fixed_string Port>
struct parameter_facts<derived<Function, Port>> {
  static constexpr auto kind = parameter_kind::derived;
  static constexpr port_info port{Port.view()};  // whose sample it is derived from
};

// A parameter may be taken by value or by reference to const.
template <class Type>
using bare_parameter =
    std::conditional_t<std::is_lvalue_reference_v<Type> && !std::is_const_v<std::remove_reference_t<Type>>,
                       Type,
                       std::remove_cvref_t<Type>>;

// What a result of the function is.
enum class result_kind : std::uint8_t { output, fault, mode_request, part_request, done, bad };

template <class Type>
struct result_facts {
  static constexpr auto kind = result_kind::bad;
  static constexpr port_info port{};
};
template <>
struct result_facts<fault> {
  static constexpr auto kind = result_kind::fault;
  static constexpr port_info port{};
};
template <fixed_string Mode>
struct result_facts<switch_to<Mode>> {
  static constexpr auto kind = result_kind::mode_request;
  static constexpr port_info port{};
  static constexpr std::string_view mode = Mode.view();
};
template <fixed_string Part>
struct result_facts<stops<Part>> {
  static constexpr auto kind = result_kind::part_request;
  static constexpr port_info port{};
  static constexpr asked_part asked{Part.view(), false};
};
template <fixed_string Part>
struct result_facts<starts<Part>> {
  static constexpr auto kind = result_kind::part_request;
  static constexpr port_info port{};
  static constexpr asked_part asked{Part.view(), true};
};
template <>
struct result_facts<done> {
  static constexpr auto kind = result_kind::done;
  static constexpr port_info port{};
};
template <fixed_string Name, class Space>
struct result_facts<out<Name, Space>> {
  static constexpr auto kind = result_kind::output;
  static constexpr port_info port{Name.view(), &space_of<checked_space<Space>>};
};
template <fixed_string Name, class Space>
struct result_facts<maybe<Name, Space>> {
  static constexpr auto kind = result_kind::output;
  static constexpr port_info port{Name.view(), &space_of<checked_space<Space>>, false, true};
};

template <class Result>
struct results_of {
  using type = list<Result>;
};
template <>
struct results_of<void> {
  using type = list<>;
};
template <class... Results>
struct results_of<std::tuple<Results...>> {
  using type = list<Results...>;
};

// The parameter and result types of a member function.
template <class Function>
struct function_facts;
template <class Result, class... Parameters>
struct function_facts<Result(Parameters...)> {
  using parameters = list<bare_parameter<Parameters>...>;
  using result = Result;
  using results = typename results_of<Result>::type;
};
template <class R, class C, class... P>
struct function_facts<R (C::*)(P...)> : function_facts<R(P...)> {};
template <class R, class C, class... P>
struct function_facts<R (C::*)(P...) const> : function_facts<R(P...)> {};
template <class R, class C, class... P>
struct function_facts<R (C::*)(P...) noexcept> : function_facts<R(P...)> {};
template <class R, class C, class... P>
struct function_facts<R (C::*)(P...) const noexcept> : function_facts<R(P...)> {};
template <class R, class C, class... P>
struct function_facts<R (C::*)(P...)&> : function_facts<R(P...)> {};
template <class R, class C, class... P>
struct function_facts<R (C::*)(P...) const&> : function_facts<R(P...)> {};
template <class R, class C, class... P>
struct function_facts<R (C::*)(P...) & noexcept> : function_facts<R(P...)> {};
template <class R, class C, class... P>
struct function_facts<R (C::*)(P...) const & noexcept> : function_facts<R(P...)> {};
template <class R, class... P>
struct function_facts<R (*)(P...)> : function_facts<R(P...)> {};
template <class R, class... P>
struct function_facts<R (*)(P...) noexcept> : function_facts<R(P...)> {};

// One function of a component, as data.
struct function_info {
  const port_info* inputs = nullptr;
  const port_info* outputs = nullptr;
  int input_count = 0, output_count = 0;
  bool may_fault = false, stops_itself = false;
  const std::string_view* requested_modes = nullptr;  // by cca::switch_to
  int requested_count = 0;
  const asked_part* asked_parts = nullptr;  // by cca::stops and cca::starts
  int asked_count = 0;
  std::string_view bad_parameter{}, bad_result{};  // names of types; empty if there is none
  bool derives = false;                            // has a cca::derived
  std::string_view bad_derived{};                  // the name in one that is no input's
};

template <class Parameters, class Results>
struct function_ports;

template <class... Parameters, class... Results>
struct function_ports<list<Parameters...>, list<Results...>> {
  static constexpr int input_count = ((parameter_facts<Parameters>::kind == parameter_kind::input) + ... + 0);
  static constexpr int output_count = ((result_facts<Results>::kind == result_kind::output) + ... + 0);

  static constexpr auto inputs = [] {
    std::array<port_info, array_size(input_count + 1)> found{};
    std::size_t n = 0;
    ((parameter_facts<Parameters>::kind == parameter_kind::input
          ? void(found[n++] = parameter_facts<Parameters>::port)
          : void()),
     ...);
    return found;
  }();
  static constexpr auto outputs = [] {
    std::array<port_info, array_size(output_count + 1)> found{};
    std::size_t n = 0;
    ((result_facts<Results>::kind == result_kind::output ? void(found[n++] = result_facts<Results>::port)
                                                         : void()),
     ...);
    return found;
  }();

  // For each parameter its position among the inputs, for each result its position among the outputs; -1 for
  // a beat, a fault, a request or `done`.
  static constexpr auto input_of_parameter = [] {
    std::array<int, sizeof...(Parameters) + 1> position{};
    int n = 0;
    std::size_t i = 0;
    ((position[i++] = parameter_facts<Parameters>::kind == parameter_kind::input ? n++ : -1), ...);
    return position;
  }();
  // Also of a cca::derived: the position of the input whose sample it is derived from.
  static constexpr auto source_of_parameter = [] {
    std::array<int, sizeof...(Parameters) + 1> position = input_of_parameter;
    [[maybe_unused]] const auto look_up = [](const port_info& named) {
      for (int i = 0; i < input_count; ++i)
        if (inputs[array_size(i)].space && inputs[array_size(i)].name == named.name) return i;
      return -1;
    };
    std::size_t i = 0;
    ((parameter_facts<Parameters>::kind == parameter_kind::derived
          ? void(position[i++] = look_up(parameter_facts<Parameters>::port))
          : void(i++)),
     ...);
    return position;
  }();
  static constexpr auto output_of_result = [] {
    std::array<int, sizeof...(Results) + 1> position{};
    int n = 0;
    std::size_t i = 0;
    ((position[i++] = result_facts<Results>::kind == result_kind::output ? n++ : -1), ...);
    return position;
  }();

  static constexpr int requested_count =
      ((result_facts<Results>::kind == result_kind::mode_request) + ... + 0);
  static constexpr auto requested_modes = [] {
    std::array<std::string_view, array_size(requested_count + 1)> found{};
    [[maybe_unused]] std::size_t n = 0;
    [[maybe_unused]] const auto add = [&]<class Result>(list<Result>) {
      if constexpr (result_facts<Result>::kind == result_kind::mode_request)
        found[n++] = result_facts<Result>::mode;
    };
    (add(list<Results>{}), ...);
    return found;
  }();

  static constexpr int asked_count = ((result_facts<Results>::kind == result_kind::part_request) + ... + 0);
  static constexpr auto asked_parts = [] {
    std::array<asked_part, array_size(asked_count + 1)> found{};
    [[maybe_unused]] std::size_t n = 0;
    [[maybe_unused]] const auto add = [&]<class Result>(list<Result>) {
      if constexpr (result_facts<Result>::kind == result_kind::part_request)
        found[n++] = result_facts<Result>::asked;
    };
    (add(list<Results>{}), ...);
    return found;
  }();

  static constexpr function_info value = [] {
    function_info function{inputs.data(), outputs.data(), input_count, output_count};
    function.may_fault = ((result_facts<Results>::kind == result_kind::fault) || ...);
    function.requested_modes = requested_modes.data();
    function.requested_count = requested_count;
    function.asked_parts = asked_parts.data();
    function.asked_count = asked_count;
    function.stops_itself = ((result_facts<Results>::kind == result_kind::done) || ...);
    ((parameter_facts<Parameters>::kind == parameter_kind::bad && function.bad_parameter.empty()
          ? void(function.bad_parameter = type_name<Parameters>())
          : void()),
     ...);
    function.derives = ((parameter_facts<Parameters>::kind == parameter_kind::derived) || ...);
    [[maybe_unused]] std::size_t i = 0;
    ((parameter_facts<Parameters>::kind == parameter_kind::derived && source_of_parameter[i] < 0 &&
              function.bad_derived.empty()
          ? void(function.bad_derived = parameter_facts<Parameters>::port.name)
          : void(),
      ++i),
     ...);
    ((result_facts<Results>::kind == result_kind::bad && function.bad_result.empty()
          ? void(function.bad_result = type_name<Results>())
          : void()),
     ...);
    return function;
  }();
};

template <class Function>
using ports_of_function =
    function_ports<typename function_facts<Function>::parameters, typename function_facts<Function>::results>;

}  // namespace cca::detail
