// Parameters: values of a component that a user may set, from a file or between two beats.
//
//   struct hopf {
//     struct parameters {
//       BOOST_HANA_DEFINE_STRUCT(parameters, (double, frequency), (cca::quantity<cca::angle>, offset));
//     };
//     parameters p{1.5, 0.0};
//
// A field is a bool, an integer, a float or double, an enumeration, a `bounded`, a `quantity`, a `text`, a
// std::array or fixed-size Eigen vector or matrix of these, or another such struct. A struct may have a
// `check() const` that returns a text: empty, or what is wrong. The outermost struct may have a
// `check_at(double step) const`, too, for bounds that follow from the rate: `step` is the time between two
// firings of the node in s. A component may have `refusal_of(values) const`, which refuses values for now,
// for example while the robot moves. Errors: rule parameters.unsupported_type; `cca::refused` for values.
// Example: docs/parameters.md.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <cca/component/component.hpp>
#include <cca/component/parameter_check.hpp>
#include <cca/base/refused.hpp>
#include <cca/component/schema.hpp>

namespace cca {

template <class Component> concept HasParameters = requires(Component& component) {
  typename Component::parameters;
  requires std::same_as<decltype(component.p), typename Component::parameters>;
};

namespace detail {

// The dotted name of the first field that no file can hold, and its type as the compiler spells it. Both are
// empty if there is none.
struct unsupported {
  char path[128]{};
  std::size_t size = 0;
  std::string_view type{};
};

constexpr bool find_unsupported(const schema& type, std::size_t size, unsupported& found) {
  if (type.what == kind::array) return find_unsupported(*type.element, size, found);
  if (type.what == kind::unsupported) {
    found.size = size;
    found.type = type.spelling;
    return true;
  }
  if (type.what != kind::table) return false;
  for (std::size_t i = 0; i < type.count; ++i) {
    std::size_t end = size;
    if (size != 0 && end < sizeof found.path) found.path[end++] = '.';
    for (const char c : type.members[i].name)
      if (end < sizeof found.path) found.path[end++] = c;
    if (find_unsupported(*type.members[i].type, end, found)) return true;
  }
  return false;
}

template <class Parameters>
inline constexpr unsupported first_unsupported = [] {
  unsupported found;
  // Not a table: BOOST_HANA_DEFINE_STRUCT is missing.
  if (schema_of<Parameters>.what != kind::table) {
    found.path[0] = 'p';
    found.size = 1;
    found.type = spelled<Parameters>();
  } else if (!std::is_copy_constructible_v<Parameters> || !std::is_copy_assignable_v<Parameters>) {
    if (!find_unsupported(schema_of<Parameters>, 0, found)) {
      found.path[0] = 'p';
      found.size = 1;
      found.type = spelled<Parameters>();
    }
  } else {
    find_unsupported(schema_of<Parameters>, 0, found);
  }
  return found;
}();

template <class Parameters>
constexpr std::string_view unsupported_field() {
  return {first_unsupported<Parameters>.path, first_unsupported<Parameters>.size};
}

template <class Parameters>
constexpr std::string_view unsupported_type() {
  return first_unsupported<Parameters>.type;
}

// Without the member `p`, a `parameters` struct would be ignored without a message.
template <class Component> concept ForgotParameters =
    requires { typename Component::parameters; } && !HasParameters<Component>;

template <class Component>
  requires HasParameters<Component>
constexpr field_problem bad_field_of<Component> = {
    .name = unsupported_field<typename Component::parameters>(),
    .type = unsupported_type<typename Component::parameters>()};
template <ForgotParameters Component>
constexpr field_problem bad_field_of<Component> = {.forgot_parameters = true};

// Bounds that follow from the rate; asked where all values are allowed by themselves.
template <class Parameters>
void check_at(const Parameters& values, std::string_view path, double step, std::vector<complaint>& found) {
  if constexpr (requires { std::string(values.check_at(step)); }) {
    if (auto what = std::string(values.check_at(step)); !what.empty())
      found.push_back({std::string(path), std::move(what)});
  }
}

template <class Complaints>
void refuse(const Complaints& found) {
  if (found.empty()) return;
  std::string text;
  for (const auto& one : found)
    text.append(text.empty() ? "" : "\n")
        .append(one.path)
        .append(one.path.empty() ? "" : ": ")
        .append(one.what);
  throw refused(text);
}

// Of values by themselves. `step` is the time between two firings of the node in s; 0: bounds that follow
// from the rate are not asked.
template <class Parameters>
std::vector<complaint> complaints_about(const Parameters& values, std::string_view path, double step) {
  std::vector<complaint> found;
  check(schema_of<Parameters>, &values, std::string(path), found);
  if (found.empty() && step > 0) check_at(values, path, step, found);
  return found;
}

}  // namespace detail

// Throws `cca::refused` with one line per problem: `cpg.frequency: 9 is out of range, expected 0.1 to 5`.
// With `step`, the time between two firings in s, also for bounds that follow from the rate.
template <class Parameters>
void check_parameters(const Parameters& values, std::string_view path = {}, double step = 0) {
  detail::refuse(detail::complaints_about(values, path, step));
}

namespace detail {

// Of a component that can't take other parameters at all times: why not now; empty: it can. The text begins
// with the name of the field.
template <class Component> concept MayRefuse =
    requires(const Component& component, const typename Component::parameters& values) {
      { component.refusal_of(values) } -> std::same_as<std::string_view>;
    };

// All that speaks against giving these values to a component now.
template <HasParameters Component>
std::vector<complaint> complaints_of(const Component& component,
                                     const typename Component::parameters& values,
                                     std::string_view path,
                                     double step) {
  auto found = complaints_about(values, path, step);
  if constexpr (MayRefuse<Component>)
    if (found.empty())
      if (const std::string_view why = component.refusal_of(values); !why.empty())
        found.push_back({{}, std::string(path) + "." + std::string(why)});
  return found;
}

// If a value is refused, the component keeps its old parameters.
template <HasParameters Component>
void apply_parameters(Component& component,
                      const typename Component::parameters& values,
                      std::string_view path = {},
                      double step = 0) {
  refuse(complaints_of(component, values, path, step));
  component.p = values;
}

}  // namespace detail
}  // namespace cca
