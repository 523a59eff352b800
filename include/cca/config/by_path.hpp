// Parameters by a path that is known only at run time: `cpg.frequency`, `arm.gains[2]`.
//
// A value is checked as one from a file, with the same messages, and by all that `set<"cpg">` asks. If it is
// refused, nothing changes. Errors: cca::refused. Example: tests/runtime/config/by_path.cpp;
// docs/parameters.md.
#pragma once

#include <algorithm>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <limits>
#include <ranges>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include <cca/component/parameters.hpp>
#include <cca/config/read.hpp>

namespace cca::detail {

struct found_field {
  const schema* type = nullptr;
  const void* at = nullptr;
};

// `rest` is what follows the component's path: names and indices. Null: there is no such field.
inline found_field field_at(const schema& type, const void* value, std::string_view rest) {
  if (rest.empty()) return {&type, value};
  if (type.what == kind::array && rest[0] == '[') {
    const auto end = std::min(rest.find(']'), rest.size());
    const auto digits = rest.substr(1, end - 1);
    std::size_t i = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), i);
    if (end == rest.size() || digits.empty() || read.ec != std::errc{} ||
        read.ptr != digits.data() + digits.size() || i >= type.count)
      return {};
    return field_at(*type.element, type.at(value, i), rest.substr(end + 1));
  }
  if (type.what != kind::table || rest[0] != '.') return {};
  rest.remove_prefix(1);
  for (std::size_t i = 0; i < type.count; ++i) {
    const member& one = type.members[i];
    if (!rest.starts_with(one.name)) continue;
    const auto after = rest.substr(one.name.size());
    if (after.empty() || after[0] == '.' || after[0] == '[') return field_at(*one.type, one.of(value), after);
  }
  return {};
}

inline void add_paths(const schema& type, const std::string& path, std::vector<std::string>& all) {
  if (type.what != kind::table) return all.push_back(path);
  for (std::size_t i = 0; i < type.count; ++i)
    add_paths(*type.members[i].type, member_path(path, type.members[i].name), all);
}

template <class Controller>
std::vector<std::string> parameter_paths(const Controller& controller) {
  std::vector<std::string> all;
  controller.for_each_component([&]<class C>(std::string_view path, const C&) {
    if constexpr (HasParameters<std::remove_const_t<C>>)
      add_paths(schema_of<typename C::parameters>, std::string(path), all);
  });
  return all;
}

// Calls f(component, what follows its path) for the component that the path leads into. Refused: of a
// deployment, a component that another process runs.
template <class Controller, class F>
void with_component_at(Controller& controller, std::string_view path, const char* call, F f) {
  bool found = false;
  controller.for_each_component([&]<class C>(std::string_view scope, C& component) {
    if constexpr (HasParameters<std::remove_const_t<C>>) {
      if (found || !path.starts_with(scope)) return;
      const auto rest = path.substr(scope.size());
      if (rest.empty() || rest[0] != '.') return;
      const found_field at = field_at(schema_of<typename C::parameters>, &component.p, rest);
      if (!at.type) return;
      found = true;
      if constexpr (requires { controller.check_is_here(scope); }) controller.check_is_here(scope);
      f(component, rest);
    }
  });
  if (found) return;
  const auto known = parameter_paths(controller);
  throw refused(std::string(call) + ": " + std::string(path) + ": " +
                unknown("parameter", path, std::vector<std::string_view>(known.begin(), known.end())));
}

inline toml::array toml_array_of(std::ranges::input_range auto&& numbers) {
  toml::array all;
  for (const auto& one : numbers) all.push_back(one);
  return all;
}

// A number, true or false, a text (of a choice, or a number with its unit), or several numbers.
template <class Value>
auto toml_node_of(const Value& value) {
  if constexpr (std::same_as<Value, bool>) return toml::value<bool>(value);
  else if constexpr (std::integral<Value>) return toml::value<std::int64_t>(static_cast<std::int64_t>(value));
  else if constexpr (std::floating_point<Value>) return toml::value<double>(static_cast<double>(value));
  else if constexpr (std::convertible_to<const Value&, std::string_view>)
    return toml::value<std::string>(std::string(std::string_view(value)));
  else return toml_array_of(value);
}

template <class Controller, class Value>
void set_parameter(Controller& controller, std::string_view path, const Value& value) {
  constexpr const char* call = "cca::controller: set";
  with_component_at(controller, path, call, [&]<class C>(C& component, std::string_view rest) {
    const schema& type = schema_of<typename C::parameters>;
    auto copy = component.p;
    const found_field at = field_at(type, &copy, rest);
    problems found(call);
    read(*at.type, const_cast<void*>(at.at), toml_node_of(value), std::string(path), {}, found);
    found.refuse();
    const auto scope = path.substr(0, path.size() - rest.size());
    for (auto& each : complaints_of(component, copy, scope, controller.step_of(scope)))
      found.add(nullptr, each.path, std::move(each.what));
    found.refuse();
    component.p = copy;
  });
}

// As a file spells it, or as a number or bool.
template <class Type, class Controller>
Type parameter(const Controller& controller, std::string_view path) {
  constexpr const char* call = "cca::controller: parameter";
  Type result{};
  with_component_at(controller, path, call, [&]<class C>(const C& component, std::string_view rest) {
    const found_field at = field_at(schema_of<typename C::parameters>, &component.p, rest);
    const kind what = at.type->what;
    const auto refuse_type = [&](const char* expected) {
      throw refused(std::string(call) + ": " + std::string(path) + ": is " + toml_value(*at.type, at.at) +
                    ", not " + expected);
    };
    if constexpr (std::same_as<Type, std::string>) {
      result = toml_value(*at.type, at.at);
    } else if constexpr (std::same_as<Type, bool>) {
      if (what != kind::boolean) refuse_type("true or false");
      result = at.type->integer(at.at) != 0;
    } else if constexpr (std::integral<Type>) {
      if (what != kind::integer || !std::in_range<Type>(at.type->integer(at.at))) refuse_type("an integer");
      result = static_cast<Type>(at.type->integer(at.at));
    } else {
      static_assert(std::floating_point<Type>,
                    "cca::controller::parameter<T>: T is std::string, bool, an integer or a number");
      if (what == kind::integer) result = static_cast<Type>(at.type->integer(at.at));
      else if (what == kind::number) result = static_cast<Type>(at.type->number(at.at));
      else refuse_type("a number");
    }
  });
  return result;
}

}  // namespace cca::detail
