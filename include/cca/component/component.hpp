// A component is a plain struct with a function `process`, whose signature is its interface. A resource node
// has `sense` (outputs) and `act` (inputs) instead: `sense` runs before all components of the beat, `act`
// after them. Optional hooks: `on_load`, `on_save`, `on_start`, `on_stop`, `on_fault`, all `void()`.
#pragma once

#include <string_view>
#include <type_traits>

#include <cca/component/hooks.hpp>
#include <cca/component/signature.hpp>

namespace cca {
namespace detail {

// True if `process` is a public function that is neither overloaded nor a template, so its type can be read.
template <class Type> concept HasProcess =
    requires { typename function_facts<decltype(&Type::process)>::result; };
template <class Type> concept HasSense =
    requires { typename function_facts<decltype(&Type::sense)>::result; };
template <class Type> concept HasAct = requires { typename function_facts<decltype(&Type::act)>::result; };
template <class Type> concept IsResource = !HasProcess<Type> && (HasSense<Type> || HasAct<Type>);

// The order within a beat: every `sense`, then every `process`, then every `act`.
enum class phase_of_beat : std::uint8_t { sense, process, act };

template <class Type, phase_of_beat Phase>
struct function_of;
template <class Type>
struct function_of<Type, phase_of_beat::sense> {
  static constexpr auto value = &Type::sense;
  using type = decltype(&Type::sense);
};
template <class Type>
struct function_of<Type, phase_of_beat::process> {
  static constexpr auto value = &Type::process;
  using type = decltype(&Type::process);
};
template <class Type>
struct function_of<Type, phase_of_beat::act> {
  static constexpr auto value = &Type::act;
  using type = decltype(&Type::act);
};

template <class Type, phase_of_beat Phase>
using ports_of_component = ports_of_function<typename function_of<Type, Phase>::type>;

// Equal for equal types. Other types differ, unless spelling, size and hash collide by accident.
template <class Type>
inline constexpr std::uint64_t type_key = hash(spelled<Type>(), sizeof(Type));

// What a type is that is no component, for the message: the text before and after the name of the graph. The
// header of such a type specialises `no_component_of`.
struct no_component {
  std::string_view before{}, after{};
};
template <class Type>
inline constexpr no_component no_component_of{};

struct component_info {
  std::string_view spelled_type{};
  std::uint64_t key = 0;  // type_key of its type
  ref<function_info> sense = nullptr;
  ref<function_info> process = nullptr;
  ref<function_info> act = nullptr;
  std::string_view bad_hook{};   // name of a hook with a wrong signature
  std::string_view bad_field{};  // name of a parameter whose type no file can hold
  std::string_view bad_field_type{};
  bool forgot_parameters = false;             // has a struct `parameters` but no member `p`
  bool also_sense = false, also_act = false;  // as well as `process`
  bool is_const = false;
  const asked_path* asked_paths = nullptr;  // of what it observes
  int asked_path_count = 0;
  std::string_view wrong_arity{};  // of a skeleton whose parts don't fit together: the rest of the message
  no_component instead{};          // what the type is, if its header says so
  bool limits_commands = false;    // a limiter: its output may reach an actuator
  bool preserves_limits = false;   // a splitter, a collector: outputs keep the limits of the inputs
  bool moves_nothing = false;      // a publisher: its `act` tells others, and is no actuator
  // Why an input can't take a constant that its writer may publish; empty: it can. Null: it takes all.
  std::string_view (*refusal)(std::string_view input, double constant) = nullptr;
  constexpr std::string_view name() const { return without_namespaces(spelled_type); }
  constexpr bool resource() const { return sense || act; }
};

// parameters.hpp specialises this for components with parameters.
struct field_problem {
  std::string_view name{}, type{};
  bool forgot_parameters = false;
};
template <class Type>
constexpr field_problem bad_field_of{};

template <class Type>
inline constexpr component_info component_of = [] {
  component_info info;
  info.spelled_type = spelled<Type>();
  info.key = type_key<Type>;
  info.is_const = std::is_const_v<Type>;
  if constexpr (HasProcess<Type>) {
    info.process = &ports_of_component<Type, phase_of_beat::process>::value;
    info.also_sense = HasSense<Type>;
    info.also_act = HasAct<Type>;
  } else {
    if constexpr (HasSense<Type>) info.sense = &ports_of_component<Type, phase_of_beat::sense>::value;
    if constexpr (HasAct<Type>) info.act = &ports_of_component<Type, phase_of_beat::act>::value;
  }
  info.bad_hook = bad_hook<Type>();
  info.bad_field = bad_field_of<Type>.name;
  info.bad_field_type = bad_field_of<Type>.type;
  info.forgot_parameters = bad_field_of<Type>.forgot_parameters;
  if constexpr (requires { Type::asked_paths.size(); }) {
    info.asked_paths = Type::asked_paths.data();
    info.asked_path_count = static_cast<int>(Type::asked_paths.size());
  }
  info.instead = no_component_of<Type>;
  if constexpr (requires { Type::wrong_arity; }) info.wrong_arity = Type::wrong_arity;
  if constexpr (requires { Type::limits_commands; }) info.limits_commands = Type::limits_commands;
  if constexpr (requires { Type::preserves_limits; }) info.preserves_limits = Type::preserves_limits;
  if constexpr (requires { Type::moves_nothing; }) info.moves_nothing = Type::moves_nothing;
  if constexpr (requires(std::string_view input) {
                  { Type::refusal(input, 0.0) } -> std::same_as<std::string_view>;
                })
    info.refusal = &Type::refusal;
  return info;
}();

}  // namespace detail

template <class Type> concept Component = detail::HasProcess<Type> || detail::IsResource<Type>;

template <class Type> concept ResourceNode = detail::IsResource<Type>;

}  // namespace cca
