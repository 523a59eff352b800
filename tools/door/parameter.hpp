// A parameter as a door describes it: its value as text, and a text as a value of it.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/space/units.hpp>

#include "members.hpp"

namespace cca_door {

struct parameter {
  std::string path{}, kind{}, unit{};  // kind: number, integer, boolean, text, numbers
  json value{};
  std::optional<double> lower{}, upper{};
  std::vector<std::string> choices{};
};

// With all its digits, and no more.
inline std::string text_of(double number) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

// As a person types it: a text without quotes, numbers with commas between them.
inline std::string text_of_value(const json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_null()) return "nan";
  if (value.is_number_float()) return text_of(value.get<double>());
  if (!value.is_array()) return written(value);
  std::string all;
  for (const json& one : value) all += (all.empty() ? "" : ",") + text_of_value(one);
  return all;
}

// `0.5 to 3 Hz`, `at least 0`, `walk, trot`; empty: any.
inline std::string range_of(const parameter& of) {
  std::string text;
  for (const std::string& one : of.choices) text += (text.empty() ? "" : ", ") + one;
  if (!of.choices.empty()) return text;
  if (of.kind == "boolean") return "true, false";
  if (of.lower && of.upper) text = text_of(*of.lower) + " to " + text_of(*of.upper);
  else if (of.lower) text = "at least " + text_of(*of.lower);
  else if (of.upper) text = "at most " + text_of(*of.upper);
  if (!text.empty() && !of.unit.empty()) text += " " + of.unit;
  return text;
}

inline std::vector<parameter> parameters_of(const json& description) {
  std::vector<parameter> all;
  for (const json& one : list_in(description, "parameters")) {
    parameter p{
        text_in(one, "path"),    text_in(one, "kind"), text_in(one, "unit"), member(one, "value"), {}, {},
        texts_in(one, "choices")};
    if (member(one, "lower").is_number()) p.lower = number_in(one, "lower");
    if (member(one, "upper").is_number()) p.upper = number_in(one, "upper");
    all.push_back(std::move(p));
  }
  return all;
}

// The units that a person may type for a number in this SI unit, as a file may; null: only that.
inline const cca::unit* units_for(std::string_view si_unit) {
  const cca::unit* found = nullptr;
  const auto look = [&](const cca::unit* all) {
    if (!found && !si_unit.empty() && all->text == si_unit) found = all;
  };
  look(cca::units_of<cca::angle>), look(cca::units_of<cca::velocity>), look(cca::units_of<cca::acceleration>);
  look(cca::units_of<cca::jerk>), look(cca::units_of<cca::torque>), look(cca::units_of<cca::torque_rate>);
  look(cca::units_of<cca::stiffness>), look(cca::units_of<cca::damping>), look(cca::units_of<cca::length>);
  look(cca::units_of<cca::speed>), look(cca::units_of<cca::force>),
      look(cca::units_of<cca::linear_stiffness>);
  look(cca::units_of<cca::linear_damping>), look(cca::units_of<cca::mass>),
      look(cca::units_of<cca::duration>);
  look(cca::units_of<cca::frequency>), look(cca::units_of<cca::power>), look(cca::units_of<cca::voltage>);
  look(cca::units_of<cca::current>);
  return found;
}
// `30 deg`, `30deg`, `0.5`. Empty: it is no number, or has no unit of this parameter.
inline std::optional<double> number_in_unit(const std::string& text, const std::string& si_unit) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || !(value - value == 0)) return {};
  std::string_view behind = end;
  behind.remove_prefix(std::min(behind.find_first_not_of(' '), behind.size()));
  if (behind.empty() || behind == si_unit) return value;
  for (const cca::unit* one = units_for(si_unit); one && !one->text.empty(); ++one)
    if (one->text == behind) return value * one->factor;
  return {};
}

// What is typed, as a value for this parameter. The door checks the range. Error: cca::refused.
inline json value_in(const parameter& of, const std::string& text) {
  const auto refuse = [&](const std::string& expected) {
    const std::string range = of.kind == "boolean" ? "" : range_of(of);
    return cca::refused(of.path + " = " + text + ": expected " + expected +
                        (range.empty() ? (of.unit.empty() ? "" : " in " + of.unit) : ", " + range));
  };
  const auto number = [&](const std::string& digits, const std::string& expected) {
    const std::optional<double> value = number_in_unit(digits, of.unit);
    if (!value) throw refuse(expected);
    return *value;
  };
  if (of.kind == "boolean") {
    if (text == "true" || text == "on" || text == "1") return true;
    if (text == "false" || text == "off" || text == "0") return false;
    throw refuse("true or false");
  }
  if (of.kind == "integer") {
    const bool has_digits = !text.empty() && text.size() < 19 &&
                            text.find_first_not_of("0123456789", text[0] == '-' ? 1 : 0) == text.npos &&
                            text != "-";
    if (!has_digits) throw refuse("a whole number");
    return std::strtoll(text.c_str(), nullptr, 10);
  }
  if (of.kind == "text") return text;
  if (of.kind != "numbers") return number(text, "a number");
  json all = json::array();
  const std::string expected =
      std::to_string(of.value.is_array() ? of.value.size() : 0) + " numbers with commas between them";
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    all.push_back(number(text.substr(at, comma - at), expected));
    at = comma + 1;
  }
  if (of.value.is_array() && all.size() != of.value.size()) throw refuse(expected);
  return all;
}

}  // namespace cca_door
