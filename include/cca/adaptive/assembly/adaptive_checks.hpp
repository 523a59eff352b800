// Compile-time checks of an adaptive component: its criterion measures in the spaces of its module, and each
// control_through<...> names an existing input. Errors: criterion.spaces, wire.unknown_port.
#pragma once

#include <array>
#include <string_view>
#include <type_traits>

#include <cca/adaptive/assembly/outer_ports.hpp>
#include <cca/adaptive/criterion.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/nearest.hpp>
#include <cca/space/messages/space_in_words.hpp>

namespace cca::detail {

// An unknown space (void) is not checked here: the wires check it.
template <class Takes, class Given>
constexpr bool may_match = matching<Takes, Given>;
template <class Takes>
constexpr bool may_match<Takes, void> = true;

// The space that a mapping gives; void without a mapping.
template <class Mapping>
struct mapped_space {
  using type = typename mapped_outputs<Mapping>::first::space;
};
template <>
struct mapped_space<void> {
  using type = void;
};

template <class CriterionSpace, class ModuleSpace>
struct other_target {
  static constexpr void tell(text& m) {
    m << "criterion.spaces: the criterion of this adaptive component measures in "
      << space_in_words<CriterionSpace>() << ", but the target of its module is in "
      << space_in_words<ModuleSpace>() << ": " << difference_in_words<CriterionSpace, ModuleSpace>()
      << "; use the criterion over the space of the module, or compare with the other target: "
         "against<criterion_target::...>";
  }
};
template <class CriterionSpace, class Mapped>
struct other_feedback {
  static constexpr void tell(text& m) {
    m << "criterion.spaces: the criterion of this adaptive component measures in "
      << space_in_words<CriterionSpace>() << ", but its feedback_through<...> maps to "
      << space_in_words<Mapped>() << ": " << difference_in_words<CriterionSpace, Mapped>()
      << "; map the feedback to the space of the criterion";
  }
};
template <class CriterionSpace, class ModuleSpace>
constexpr bool check_target() {
  constexpr bool match = may_match<CriterionSpace, ModuleSpace>;
  static_assert(holds_or_tells<match, other_target<CriterionSpace, ModuleSpace>>::value);
  return match;
}
template <class CriterionSpace, class Mapped>
constexpr bool check_feedback() {
  constexpr bool match = may_match<CriterionSpace, Mapped>;
  static_assert(holds_or_tells<match, other_feedback<CriterionSpace, Mapped>>::value);
  return match;
}
template <class CriterionTarget, class ModuleTarget, class CriterionFeedback, class MappedFeedback>
constexpr bool check_criterion() {
  if constexpr (check_target<CriterionTarget, ModuleTarget>())
    return check_feedback<CriterionFeedback, MappedFeedback>();
  else return false;
}

// Replaces a criterion that was refused, so that its mistake causes no further errors.
template <class Target, class Feedback>
struct placeholder_criterion {
  auto process(in<"target", Target>, in<"feedback", Feedback>)
      -> std::tuple<out<"error", criterion_error>, out<"state", criterion_port>> {
    return {};
  }
};

// Whether a control_through<...> names an input of the module or the criterion that has no role.
template <class Option, class ModulePorts, class ModuleRoles, class CriterionPorts, class CriterionRoles>
constexpr bool control_exists = true;
template <fixed_string Name, class Ports, class Roles>
constexpr bool has_control_input = false;
template <fixed_string Name, class Ports, fixed_string... Roles>
constexpr bool has_control_input<Name, Ports, roles<Roles...>> =
    port_at<Name, Ports>::exists && ((Name.view() != Roles.view()) && ...);
template <fixed_string Name,
          class M,
          class ModulePorts,
          class ModuleRoles,
          class CriterionPorts,
          class CriterionRoles>
constexpr bool
    control_exists<control_through<Name, M>, ModulePorts, ModuleRoles, CriterionPorts, CriterionRoles> =
        has_control_input<Name, ModulePorts, ModuleRoles> ||
        has_control_input<Name, CriterionPorts, CriterionRoles>;

template <class... Ports>
constexpr auto port_names_in(list<Ports...>) {
  constexpr auto one = []<class Port>(std::type_identity<Port>) -> std::string_view {
    if constexpr (requires { Port::name; }) return Port::name;
    else return {};
  };
  return std::array<std::string_view, sizeof...(Ports)>{one(std::type_identity<Ports>())...};
}

// Whether all are found; else the first that is not.
template <class ModulePorts, class ModuleRoles, class CriterionPorts, class CriterionRoles, class... Options>
struct asked_controls {
  template <class Option>
  static constexpr bool exists =
      control_exists<Option, ModulePorts, ModuleRoles, CriterionPorts, CriterionRoles>;
  static constexpr bool exist = (exists<Options> && ...);

  static constexpr void tell(text& m) {
    (void)((exists<Options> || (one(m, std::type_identity<Options>()), false)) && ...);
  }

private:
  static constexpr void one(text&, auto) {}
  template <fixed_string Name, class M>
  static constexpr void one(text& m, std::type_identity<control_through<Name, M>>) {
    m << "wire.unknown_port: cca::control_through<`" << Name.view() << "`, " << type_name<M>()
      << "> of this adaptive component names no control input of its module or its criterion";
    auto near = nearest_name(Name.view(), port_names_in(ModulePorts()));
    if (near.empty()) near = nearest_name(Name.view(), port_names_in(CriterionPorts()));
    if (!near.empty()) m << "; did you mean `" << near << "`?";
    else
      m << "; reference, feedback and command have options of their own: reference_through<M>, "
           "feedback_through<M>, command_through<M>";
  }
};

template <class Controls>
constexpr bool check_controls() {
  static_assert(holds_or_tells<Controls::exist, Controls>::value);
  return true;
}

}  // namespace cca::detail
