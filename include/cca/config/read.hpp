// Reads a TOML node into a field of a parameters struct. A value that doesn't fit is reported and not set.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include <cca/base/nearest.hpp>
#include <cca/config/problems.hpp>
#include <cca/config/spelling.hpp>
#include <cca/config/measure.hpp>

namespace cca::detail {

inline std::string shortened(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string shown(text.substr(0, longest));
  if (text.size() > longest) shown.append("...");
  return shown;
}

// `a string "fast"`, `the integer 3`
inline std::string got(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string \"" + shortened(node.as_string()->get()) + "\"";
    case toml::node_type::integer:
      return "the integer " + std::to_string(node.as_integer()->get());
    case toml::node_type::floating_point:
      return "the number " + toml_number(schema{}, node.as_floating_point()->get());
    case toml::node_type::boolean:
      return node.as_boolean()->get() ? "true" : "false";
    case toml::node_type::date:
      return "a date";
    case toml::node_type::time:
      return "a time";
    case toml::node_type::date_time:
      return "a date and time";
    case toml::node_type::none:
      break;
  }
  return "nothing";
}

inline std::string wanted(const schema& type) {
  switch (type.what) {
    case kind::boolean:
      return "true or false";
    case kind::integer:
      return "an integer";
    case kind::number:
      return type.unit.empty() ? "a number" : "a number, in " + std::string(type.unit) + " or with its unit";
    case kind::choice:
      return names_text(type);
    case kind::text:
      return "a text";
    case kind::array:
      return "an array of " + std::to_string(type.count);
    case kind::table:
      return "a table";
    case kind::unsupported:
      break;
  }
  return "nothing";
}

// The example is the value that the field has now; `key` is empty for an element of an array.
inline std::string mismatch(const schema& type,
                            const void* value,
                            const toml::node& node,
                            std::string_view key) {
  const std::string example =
      key.empty() ? toml_value(type, value) : toml_key(key) + " = " + toml_value(type, value);
  return "expected " + wanted(type) + ", got " + got(node) + "; for example `" + example + "`";
}

inline std::string read_number(const schema& type,
                               void* value,
                               const toml::node& node,
                               std::string_view key) {
  double number = 0;
  std::string shown;
  if (const auto* text = node.as_string(); text && type.units) {
    auto read = measure(text->get(), type.units);
    if (!read.complaint.empty()) return std::move(read.complaint);
    number = read.value;
    shown = read.converted ? text->get() + " (" + with_unit(number_text(number), type) + ")" : text->get();
  } else if (const auto* integer = node.as_integer()) {
    constexpr std::int64_t exact = std::int64_t{1} << 53;
    if (integer->get() > exact || integer->get() < -exact)
      return std::to_string(integer->get()) + " is not held exactly, write it as a number, with a point";
    number = static_cast<double>(integer->get());
    shown = with_unit(number_text(number), type);
  } else if (const auto* floating = node.as_floating_point()) {
    number = floating->get();
    shown = with_unit(number_text(number), type);
  } else {
    return mismatch(type, value, node, key);
  }
  if (type.single && std::isfinite(number)) {
    // The shortest text of the largest float is above it by less than half of its last bit.
    constexpr double largest = std::numeric_limits<float>::max();
    if (std::abs(number) > largest && std::abs(number) < largest * (1 + 0x1p-25))
      number = std::copysign(largest, number);
    if (std::abs(number) <= largest) number = static_cast<double>(static_cast<float>(number));
  }
  auto complaint = number_complaint(type, number, shown);
  if (complaint.empty()) type.set_number(value, number);
  return complaint;
}

inline std::string read_integer(const schema& type,
                                void* value,
                                const toml::node& node,
                                std::string_view key) {
  const auto* integer = node.as_integer();
  if (!integer) return mismatch(type, value, node, key);
  auto complaint = integer_complaint(type, integer->get());
  if (complaint.empty()) type.set_integer(value, integer->get());
  return complaint;
}

inline std::string read_boolean(const schema& type,
                                void* value,
                                const toml::node& node,
                                std::string_view key) {
  const auto* boolean = node.as_boolean();
  if (!boolean) return mismatch(type, value, node, key);
  type.set_integer(value, boolean->get());
  return {};
}

inline std::string read_choice(const schema& type,
                               void* value,
                               const toml::node& node,
                               std::string_view key) {
  const auto* text = node.as_string();
  if (!text) return mismatch(type, value, node, key);
  const std::span names(type.names, type.count);
  const auto found = std::ranges::find(names, std::string_view(text->get()));
  if (text->get().empty() || found == names.end())
    return "unknown name \"" + shortened(text->get()) + "\", expected " + names_text(type);
  type.set_integer(value, found - names.begin());
  return {};
}

inline std::string read_text(const schema& type, void* value, const toml::node& node, std::string_view key) {
  const auto* text = node.as_string();
  if (!text) return mismatch(type, value, node, key);
  if (type.set_characters(value, text->get())) return {};
  return "the text has " + std::to_string(text->get().size()) + " bytes, expected at most " +
         std::to_string(type.count);
}

inline void read_table(
    const schema& type, void* value, const toml::table* table, const std::string& path, problems& found);

// `key` is the field's name; empty for an element of an array.
inline void read(const schema& type,
                 void* value,
                 const toml::node& node,
                 const std::string& path,
                 std::string_view key,
                 problems& found) {
  if (type.what == kind::table) {
    if (const auto* table = node.as_table()) return read_table(type, value, table, path, found);
    return found.add(node, path, mismatch(type, value, node, key));
  }
  if (type.what == kind::array) {
    const auto* array = node.as_array();
    if (!array) return found.add(node, path, mismatch(type, value, node, key));
    if (array->size() != type.count)
      return found.add(node, path,
                       "expected an array of " + std::to_string(type.count) + ", got one of " +
                           std::to_string(array->size()));
    for (std::size_t i = 0; i < type.count; ++i)
      read(*type.element, const_cast<void*>(type.at(value, i)), *array->get(i), element_path(path, i), {},
           found);
    return;
  }
  std::string complaint;
  switch (type.what) {
    case kind::number:
      complaint = read_number(type, value, node, key);
      break;
    case kind::integer:
      complaint = read_integer(type, value, node, key);
      break;
    case kind::boolean:
      complaint = read_boolean(type, value, node, key);
      break;
    case kind::choice:
      complaint = read_choice(type, value, node, key);
      break;
    case kind::text:
      complaint = read_text(type, value, node, key);
      break;
    default:
      break;
  }
  if (!complaint.empty()) found.add(node, path, std::move(complaint));
}

// "unknown parameter, did you mean `frequency`?", or a list of the names that exist.
inline std::string unknown(std::string_view what,
                           std::string_view wrong,
                           const std::vector<std::string_view>& names) {
  std::string text = "unknown " + std::string(what);
  if (const auto near = nearest_name(wrong, names); !near.empty())
    return text + ", did you mean `" + std::string(near) + "`?";
  if (names.empty()) return text + ", this node has none";
  text.append(", there are ");
  constexpr std::size_t listed = 8;
  for (std::size_t i = 0; i < std::min(listed, names.size()); ++i)
    text.append(i ? ", `" : "`").append(names[i]).append("`");
  return names.size() > listed ? text + " and others" : text;
}

// `table` may be null: fields that the file does not mention are checked too, and so is the struct as a
// whole.
inline void read_table(
    const schema& type, void* value, const toml::table* table, const std::string& path, problems& found) {
  const std::size_t before = found.count();
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < type.count; ++i) names.push_back(type.members[i].name);
  if (table)
    for (auto&& [key, node] : *table)
      if (std::ranges::find(names, key.str()) == names.end())
        found.add(&key.source(), member_path(path, key.str()), unknown("parameter", key.str(), names));
  for (std::size_t i = 0; i < type.count; ++i) {
    const member& one = type.members[i];
    void* const at = const_cast<void*>(one.of(value));
    const std::string here = member_path(path, one.name);
    if (const toml::node* node = table ? table->get(one.name) : nullptr) {
      read(*one.type, at, *node, here, one.name, found);
    } else if (one.type->what == kind::table) {
      read_table(*one.type, at, nullptr, here, found);
    } else {
      std::vector<complaint> complaints;
      check(*one.type, at, here, complaints);
      for (auto& each : complaints) found.add(nullptr, each.path, std::move(each.what));
    }
  }
  if (!type.complaint || found.count() != before) return;
  if (auto what = type.complaint(value); !what.empty())
    found.add(table ? &table->source() : nullptr, path, std::move(what));
}

}  // namespace cca::detail
