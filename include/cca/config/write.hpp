// Writes a parameters struct as TOML text: one table per struct, with ranges, choices and earlier values as
// comments.
#pragma once

#include <string>
#include <string_view>

#include <cca/config/spelling.hpp>

namespace cca::detail {

inline std::string range_comment(const schema& type) {
  if (type.what == kind::array) return range_comment(*type.element);
  if (type.what == kind::choice) return names_text(type);
  return type.stated_range ? range_text(type) : std::string{};
}
// The range, and what the value was where `before` has another one.
inline std::string comment(const schema& type, const std::string& now, const void* before) {
  std::string text = range_comment(type);
  if (before)
    if (const std::string was = toml_value(type, before); was != now)
      text.append(text.empty() ? "was " : "; was ").append(was);
  return text.empty() ? text : "  # " + text;
}

// A long array of arrays or tables gets one line per element.
inline std::string toml_lines(const schema& type, const void* value) {
  constexpr std::size_t longest = 100;
  std::string line = toml_value(type, value);
  if (type.what != kind::array || line.size() < longest ||
      (type.element->what != kind::array && type.element->what != kind::table))
    return line;
  std::string lines = "[\n";
  for (std::size_t i = 0; i < type.count; ++i)
    lines.append("  ").append(toml_value(*type.element, type.at(value, i))).append(",\n");
  return lines.append("]");
}

// `before`: the value at an earlier time, or null. `path` is spelled as TOML. A table's values come before
// its inner tables: after them they would belong to those.
inline void write_table(
    const schema& type, const void* value, const void* before, const std::string& path, std::string& out) {
  if (type.count) out.append(out.empty() ? "[" : "\n[").append(path).append("]\n");
  for (std::size_t i = 0; i < type.count; ++i) {
    const member& one = type.members[i];
    if (one.type->what != kind::table)
      out.append(toml_key(one.name))
          .append(" = ")
          .append(toml_lines(*one.type, one.of(value)))
          .append(comment(*one.type, toml_value(*one.type, one.of(value)), before ? one.of(before) : nullptr))
          .append("\n");
  }
  for (std::size_t i = 0; i < type.count; ++i) {
    const member& one = type.members[i];
    if (one.type->what == kind::table)
      write_table(*one.type, one.of(value), before ? one.of(before) : nullptr,
                  path + "." + toml_key(one.name), out);
  }
}

}  // namespace cca::detail
