// The functions of parameters by a path that depend on no controller. by_path.hpp includes this, unless they
// are compiled once for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include <cca/base/refused.hpp>
#include <cca/config/by_path.hpp>
#include <cca/config/problems.hpp>
#include <cca/config/read.hpp>
#include <cca/config/spelling.hpp>

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

CCA_CONFIG_INLINE std::vector<std::string> paths_of_fields(const std::vector<component_values>& all) {
  std::vector<std::string> paths;
  for (const component_values& one : all) add_paths(*one.type, one.path, paths);
  return paths;
}

CCA_CONFIG_INLINE found_parameter parameter_at(const std::vector<component_values>& all,
                                               std::string_view path,
                                               const char* call) {
  for (const component_values& one : all) {
    if (!path.starts_with(one.path)) continue;
    const auto rest = path.substr(one.path.size());
    if (rest.empty() || rest[0] != '.') continue;
    if (const found_field found = field_at(*one.type, one.values, rest); found.type)
      return {one.path, found.type, found.at};
  }
  const auto known = paths_of_fields(all);
  throw refused(std::string(call) + ": " + std::string(path) + ": " +
                unknown("parameter", path, std::vector<std::string_view>(known.begin(), known.end())));
}

inline void add_to(toml::array& all, const given_value& value) {
  switch (value.what) {
    case kind::boolean:
      return all.push_back(value.integer != 0);
    case kind::integer:
      return all.push_back(value.integer);
    case kind::number:
      return all.push_back(value.number);
    case kind::text:
      return all.push_back(value.text);
    default:
      toml::array elements;
      for (const given_value& one : value.elements) add_to(elements, one);
      all.push_back(std::move(elements));
  }
}

CCA_CONFIG_INLINE void put_given_value(const schema& type,
                                       void* values,
                                       std::string_view scope,
                                       std::string_view path,
                                       const given_value& value) {
  const found_field field = field_at(type, values, path.substr(scope.size()));
  toml::array only;
  add_to(only, value);
  problems found("cca::controller: set");
  read(*field.type, const_cast<void*>(field.at), *only.get(0), std::string(path), {}, found);
  found.refuse();
}

CCA_CONFIG_INLINE void refuse_given_value(std::vector<complaint> complaints) {
  problems found("cca::controller: set");
  for (auto& each : complaints) found.add(nullptr, each.path, std::move(each.what));
  found.refuse();
}

CCA_CONFIG_INLINE void refuse_type(const found_parameter& found,
                                   std::string_view path,
                                   const char* expected) {
  throw refused("cca::controller: parameter: " + std::string(path) + ": is " + text_in(found) + ", not " +
                expected);
}

CCA_CONFIG_INLINE std::string text_in(const found_parameter& found) {
  return toml_value(*found.type, found.at);
}

CCA_CONFIG_INLINE bool boolean_in(const found_parameter& found, std::string_view path) {
  if (found.type->what != kind::boolean) refuse_type(found, path, "true or false");
  return found.type->integer(found.at) != 0;
}

CCA_CONFIG_INLINE std::int64_t integer_in(const found_parameter& found, std::string_view path) {
  if (found.type->what != kind::integer) refuse_type(found, path, "an integer");
  return found.type->integer(found.at);
}

CCA_CONFIG_INLINE double number_in_parameter(const found_parameter& found, std::string_view path) {
  if (found.type->what == kind::integer) return static_cast<double>(found.type->integer(found.at));
  if (found.type->what != kind::number) refuse_type(found, path, "a number");
  return found.type->number(found.at);
}

}  // namespace cca::detail
