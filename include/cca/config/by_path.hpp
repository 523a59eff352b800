// Parameters by a path that is known only at run time: `cpg.frequency`, `arm.gains[2]`.
//
// A value is checked as one from a file, with the same messages, and by all that `set<"cpg">` asks. If it is
// refused, nothing changes. Errors: cca::refused. Example: tests/runtime/config/by_path.cpp;
// docs/parameters.md.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/separate/compiled.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/testing/test_mark.hpp>

namespace cca::detail {

template <class Component>
struct field_of_no_file {
  static constexpr void tell(text& m) {
    m << "parameters.unsupported_type: the field `" << unsupported_field<typename Component::parameters>()
      << "` of the parameters of " << type_name<Component>() << " has a type that no file can hold";
  }
};
template <HasParameters Component>
constexpr const schema& parameters_schema() {
  static_assert(holds_or_tells<unsupported_field<typename Component::parameters>().empty(),
                               field_of_no_file<Component>>::value);
  return schema_of<typename Component::parameters>;
}

// The parameters of one component of a controller.
struct component_values {
  std::string path;  // of the component
  const schema* type;
  const void* values;
};

template <class Controller>
std::vector<component_values> values_of_components(const Controller& controller) {
  std::vector<component_values> all;
  controller.for_each_component([&]<class Component>(std::string_view path, const Component& component) {
    if constexpr (HasParameters<Component>)
      all.push_back({std::string(path), &parameters_schema<Component>(), &component.p});
  });
  return all;
}

// Those that a file gets.
template <class Controller>
std::vector<component_values> values_to_save(const Controller& controller) {
  std::vector<component_values> all;
  controller.for_each_component([&]<class Component>(std::string_view path, const Component& component) {
    if constexpr (HasParameters<Component> && !TestNode<Component>)
      all.push_back({std::string(path), &parameters_schema<Component>(), &component.p});
  });
  return all;
}

std::vector<std::string> paths_of_fields(const std::vector<component_values>& all);

struct found_parameter {
  std::string scope;  // the component's path
  const schema* type;
  const void* at;
};

// The parameter at a path. Throws if there is none; `call`: who asks.
found_parameter parameter_at(const std::vector<component_values>& all,
                             std::string_view path,
                             const char* call);

// What a program gives as a value: a boolean, an integer, a number, a text, or several.
struct given_value {
  kind what;
  std::int64_t integer = 0;
  double number = 0;
  std::string text{};
  std::vector<given_value> elements{};
};

// A number, true or false, a text (of a choice, or a number with its unit), or several numbers.
template <class Value>
given_value given_value_of(const Value& value) {
  if constexpr (std::same_as<Value, given_value>) return value;
  else if constexpr (std::same_as<Value, bool>) return {.what = kind::boolean, .integer = value};
  else if constexpr (std::integral<Value>)
    return {.what = kind::integer, .integer = static_cast<std::int64_t>(value)};
  else if constexpr (std::floating_point<Value>)
    return {.what = kind::number, .number = static_cast<double>(value)};
  else if constexpr (std::convertible_to<const Value&, std::string_view>)
    return {.what = kind::text, .text = std::string(std::string_view(value))};
  else {
    given_value all{.what = kind::array};
    for (const auto& one : value) all.elements.push_back(given_value_of(one));
    return all;
  }
}

// Into the field that `path` names after the path of its component. Throws if it doesn't fit.
void put_given_value(const schema& type,
                     void* values,
                     std::string_view scope,
                     std::string_view path,
                     const given_value& value);
// Throws if there is a complaint.
void refuse_given_value(std::vector<complaint> found);

template <class Controller>
std::vector<std::string> parameter_paths(const Controller& controller) {
  return paths_of_fields(values_of_components(controller));
}

// Refused: of a deployment, a component that another process runs.
template <class Controller>
found_parameter parameter_here(const Controller& controller, std::string_view path, const char* call) {
  auto found = parameter_at(values_of_components(controller), path, call);
  if constexpr (requires { controller.check_is_here(found.scope); }) controller.check_is_here(found.scope);
  return found;
}

template <class Controller>
void set_parameter(Controller& controller, std::string_view path, const given_value& value) {
  const found_parameter found = parameter_here(controller, path, "cca::controller: set");
  controller.for_each_component([&]<class Component>(std::string_view scope, Component& component) {
    if constexpr (HasParameters<Component>) {
      if (scope != found.scope) return;
      auto copy = component.p;
      put_given_value(parameters_schema<Component>(), &copy, scope, path, value);
      refuse_given_value(complaints_of(component, copy, scope, controller.step_of(scope)));
      component.p = copy;
    }
  });
}

std::string text_in(const found_parameter& found);
// Refused: the parameter is none, with `path` in the message.
bool boolean_in(const found_parameter& found, std::string_view path);
std::int64_t integer_in(const found_parameter& found, std::string_view path);
double number_in_parameter(const found_parameter& found, std::string_view path);
[[noreturn]] void refuse_type(const found_parameter& found, std::string_view path, const char* expected);

template <class Type>
struct read_as_other {
  static constexpr void tell(text& m) {
    m << "cca::controller::parameter: a parameter is read as `" << type_name<Type>()
      << "`, which is neither std::string, bool, an integer nor a number: take one of these";
  }
};

// As a file spells it, or as a number or bool.
template <class Type, class Controller>
Type parameter(const Controller& controller, std::string_view path) {
  const found_parameter found = parameter_here(controller, path, "cca::controller: parameter");
  if constexpr (std::same_as<Type, std::string>) return text_in(found);
  else if constexpr (std::same_as<Type, bool>) return boolean_in(found, path);
  else if constexpr (std::integral<Type>) {
    const std::int64_t value = integer_in(found, path);
    if (!std::in_range<Type>(value)) refuse_type(found, path, "an integer");
    return static_cast<Type>(value);
  } else {
    static_assert(holds_or_tells<std::floating_point<Type>, read_as_other<Type>>::value);
    if constexpr (std::floating_point<Type>) return static_cast<Type>(number_in_parameter(found, path));
    else return Type{};
  }
}

}  // namespace cca::detail

#if !CCA_HAS_COMPILED_CONFIG
#include <cca/config/by_path_functions.hpp>
#endif
