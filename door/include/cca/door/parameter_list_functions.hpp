// The functions of parameter_list.hpp. It includes this, unless they are compiled once for the program
// (cca/base/separate/compiled.hpp).
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <cca/component/schema.hpp>
#include <cca/door/parameter_list.hpp>

namespace cca::detail {

// A text, a choice, a number or a boolean; false: it is none of these.
inline bool put_simple(const schema& type, const void* at, door_parameter& one) {
  switch (type.what) {
    case kind::boolean:
      one.value = {.what = door_value::kind::boolean, .integer = type.integer(at)};
      return true;
    case kind::integer:
      one.value = {.what = door_value::kind::integer, .integer = type.integer(at)};
      if (type.stated_range) {
        one.lower = static_cast<double>(type.lowest);
        one.upper = static_cast<double>(type.highest);
      }
      return true;
    case kind::number:
      one.value = {.number = type.number(at)};
      one.unit = type.unit;
      if (type.stated_range) one.lower = type.lower, one.upper = type.upper;
      return true;
    case kind::choice: {
      for (std::size_t i = 0; i < type.count; ++i)
        if (!type.names[i].empty()) one.choices.emplace_back(type.names[i]);
      const auto number = static_cast<std::size_t>(type.integer(at));
      one.value.what = door_value::kind::text;
      if (number < type.count) one.value.text = type.names[number];
      return true;
    }
    case kind::text:
      one.value = {.what = door_value::kind::text, .text = std::string(type.characters(at))};
      return true;
    default:
      return false;
  }
}

inline bool holds_numbers(const schema& type) {
  return type.what == kind::array && type.element->what == kind::number;
}

inline void add_door_parameters(const schema& type,
                                const void* at,
                                const std::string& path,
                                std::vector<door_parameter>& all) {
  door_parameter one{.path = path};
  if (type.what == kind::table) {
    for (std::size_t i = 0; i < type.count; ++i)
      add_door_parameters(*type.members[i].type, type.members[i].of(at),
                          member_path(path, type.members[i].name), all);
  } else if (holds_numbers(type)) {
    one.value.what = door_value::kind::numbers;
    one.unit = type.element->unit;
    if (type.element->stated_range) one.lower = type.element->lower, one.upper = type.element->upper;
    for (std::size_t i = 0; i < type.count; ++i)
      one.value.numbers.push_back(type.element->number(type.at(at, i)));
    all.push_back(std::move(one));
  } else if (type.what == kind::array) {
    for (std::size_t i = 0; i < type.count; ++i)
      add_door_parameters(*type.element, type.at(at, i), element_path(path, i), all);
  } else if (put_simple(type, at, one)) {
    all.push_back(std::move(one));
  }
}

CCA_DOOR_INLINE std::vector<door_parameter> door_parameters(const std::vector<component_values>& components) {
  std::vector<door_parameter> all;
  for (const component_values& one : components) add_door_parameters(*one.type, one.values, one.path, all);
  return all;
}

CCA_DOOR_INLINE given_value given_value_of_door(const door_value& value) {
  switch (value.what) {
    case door_value::kind::boolean:
      return {.what = kind::boolean, .integer = value.integer};
    case door_value::kind::integer:
      return {.what = kind::integer, .integer = value.integer};
    case door_value::kind::text:
      return {.what = kind::text, .text = value.text};
    case door_value::kind::numbers:
      return given_value_of(value.numbers);
    default:
      return {.what = kind::number, .number = value.number};
  }
}

}  // namespace cca::detail
