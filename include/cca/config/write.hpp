// Writes a parameters struct as TOML text: one table per struct, with ranges and choices as comments.
#pragma once

#include <string>
#include <string_view>

#include <cca/config/spelling.hpp>

namespace cca::detail {

inline std::string comment(const schema& type) {
  if (type.what == kind::array) return comment(*type.element);
  if (type.what == kind::choice) return "  # " + names_text(type);
  const std::string range = type.stated_range ? range_text(type) : std::string{};
  return range.empty() ? range : "  # " + range;
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

// `path` is spelled as TOML. A table's values come before its inner tables: after them they would belong to
// those.
inline void write_table(const schema& type, const void* value, const std::string& path, std::string& out) {
  if (type.count) out.append(out.empty() ? "[" : "\n[").append(path).append("]\n");
  for (std::size_t i = 0; i < type.count; ++i) {
    const member& one = type.members[i];
    if (one.type->what != kind::table)
      out.append(toml_key(one.name))
          .append(" = ")
          .append(toml_lines(*one.type, one.of(value)))
          .append(comment(*one.type))
          .append("\n");
  }
  for (std::size_t i = 0; i < type.count; ++i) {
    const member& one = type.members[i];
    if (one.type->what == kind::table)
      write_table(*one.type, one.of(value), path + "." + toml_key(one.name), out);
  }
}

}  // namespace cca::detail
