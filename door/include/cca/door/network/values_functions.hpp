// JSON that clients send, and the values of parameters in it. What is wrong is refused with unit and range.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <cca/door/controls.hpp>

namespace cca::detail::door_network {

using json = nlohmann::json;

// An object whose depth is bounded, before anything is made of it; none: it is no JSON, or no object.
inline std::optional<json> read_json(std::string_view text, std::size_t most_depth) {
  std::size_t depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_text && c == '\\') ++i;
    else if (c == '"') in_text = !in_text;
    else if (in_text) continue;
    else if ((c == '[' || c == '{') && ++depth > most_depth) return {};
    else if ((c == ']' || c == '}') && depth > 0) --depth;
  }
  json all = json::parse(text.begin(), text.end(), nullptr, false);
  if (!all.is_object()) return {};
  return all;
}

// Bytes that are no UTF-8 are replaced: a name of a file may have any.
inline std::string written(const json& all) {
  return all.dump(-1, ' ', false, json::error_handler_t::replace);
}

// A member of an object, or null.
inline const json* member(const json& of, const char* name) {
  const auto found = of.find(name);
  return found == of.end() ? nullptr : &*found;
}
inline std::string text_member(const json& of, const char* name) {
  const json* one = member(of, name);
  return one && one->is_string() ? one->get<std::string>() : std::string();
}
inline std::optional<std::uint32_t> small_number(const json* one) {
  if (!one || !one->is_number_integer()) return {};
  if (!one->is_number_unsigned() && one->get<std::int64_t>() < 0) return {};
  const auto number = one->get<std::uint64_t>();
  if (number > std::numeric_limits<std::uint32_t>::max()) return {};
  return static_cast<std::uint32_t>(number);
}

inline json json_of(double number) { return std::isfinite(number) ? json(number) : json(nullptr); }
inline json json_of(const door_value& value) {
  using kind = door_value::kind;
  switch (value.what) {
    case kind::number:
      return json_of(value.number);
    case kind::integer:
      return value.integer;
    case kind::boolean:
      return value.integer != 0;
    case kind::text:
      return value.text;
    case kind::numbers:
      break;
  }
  json all = json::array();
  for (const double one : value.numbers) all.push_back(json_of(one));
  return all;
}
inline const char* name_of(door_value::kind kind) {
  using of = door_value::kind;
  return kind == of::number    ? "number"
         : kind == of::integer ? "integer"
         : kind == of::boolean ? "boolean"
         : kind == of::text    ? "text"
                               : "numbers";
}

// With ten digits, or as many as tell it from every other number: one that is refused differs from its bound.
inline std::string number_text(double number) {
  char text[32];
  for (int digits = 10; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    if (std::strtod(text, nullptr) == number) break;
  }
  return text;
}
inline std::string text_of(const json& value) {
  std::string text = value.is_number_float() ? number_text(value.get<double>()) : written(value);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}
inline std::string range_text(std::optional<double> lower,
                              std::optional<double> upper,
                              const std::string& unit) {
  const std::string behind = unit.empty() ? "" : " " + unit;
  if (lower && upper) return "from " + number_text(*lower) + " to " + number_text(*upper) + behind;
  if (lower) return "at least " + number_text(*lower) + behind;
  return "at most " + number_text(upper.value_or(0)) + behind;
}
inline bool is_within(double number, std::optional<double> lower, std::optional<double> upper) {
  return !(lower && number < *lower) && !(upper && number > *upper);
}

// The value for that parameter; else `why` says what is wrong with it.
inline std::optional<door_value> value_for(const door_parameter& of, const json* given, std::string& why) {
  using kind = door_value::kind;
  const auto refuse = [&](const std::string& expected) {
    why = of.path + " = " + (given ? text_of(*given) : "nothing") + ": expected " + expected;
    return std::nullopt;
  };
  const std::string unit = of.unit.empty() ? "" : " in " + of.unit;
  const auto in_range = [&](double number) { return is_within(number, of.lower, of.upper); };
  door_value value{.what = of.value.what};
  if (!given || given->is_null()) return refuse("a value: a parameter can't be removed");
  switch (value.what) {
    case kind::number:
      if (!given->is_number()) return refuse("a number" + unit);
      value.number = given->get<double>();
      if (!in_range(value.number)) return refuse("a number " + range_text(of.lower, of.upper, of.unit));
      return value;
    case kind::integer: {
      constexpr double most = 9007199254740992;  // beyond, a number of JavaScript is not exact
      if (given->is_number_float()) {
        const double number = given->get<double>();
        if (number != std::floor(number) || std::abs(number) > most) return refuse("a whole number" + unit);
        value.integer = static_cast<std::int64_t>(number);
      } else if (!given->is_number_integer() ||
                 (given->is_number_unsigned() &&
                  given->get<std::uint64_t>() >
                      static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))) {
        return refuse("a whole number" + unit);
      } else {
        value.integer = given->get<std::int64_t>();
      }
      if (!in_range(static_cast<double>(value.integer)))
        return refuse("a whole number " + range_text(of.lower, of.upper, of.unit));
      return value;
    }
    case kind::boolean:
      if (!given->is_boolean()) return refuse("true or false");
      value.integer = given->get<bool>() ? 1 : 0;
      return value;
    case kind::text: {
      std::string choices;
      for (const auto& one : of.choices) choices += (choices.empty() ? "" : ", ") + one;
      if (!given->is_string()) return refuse(choices.empty() ? "a text" : "one of " + choices);
      value.text = given->get<std::string>();
      if (!of.choices.empty() &&
          std::find(of.choices.begin(), of.choices.end(), value.text) == of.choices.end())
        return refuse("one of " + choices);
      return value;
    }
    case kind::numbers:
      break;
  }
  const std::string expected = std::to_string(of.value.numbers.size()) + " numbers" +
                               (of.lower || of.upper ? " " + range_text(of.lower, of.upper, of.unit) : unit);
  if (!given->is_array() || given->size() != of.value.numbers.size()) return refuse(expected);
  for (const json& one : *given) {
    if (!one.is_number() || !in_range(one.get<double>())) return refuse(expected);
    value.numbers.push_back(one.get<double>());
  }
  return value;
}

}  // namespace cca::detail::door_network
