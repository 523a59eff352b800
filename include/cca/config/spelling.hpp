// Values and keys as TOML spells them: for files that are saved and for the examples in messages.
#pragma once

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

#include <cca/component/parameter_check.hpp>

namespace cca::detail {

inline std::string toml_string(std::string_view text) {
  constexpr std::string_view hex = "0123456789ABCDEF";
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') out.append({'\\', c});
    else if (c == '\n') out.append("\\n");
    else if (c == '\t') out.append("\\t");
    else if (byte < 0x20 || byte == 0x7F) out.append("\\u00").append({hex[byte >> 4], hex[byte & 15]});
    else out.push_back(c);
  }
  return out.append("\"");
}

inline std::string toml_key(std::string_view name) {
  constexpr std::string_view bare = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
  return !name.empty() && name.find_first_not_of(bare) == name.npos ? std::string(name) : toml_string(name);
}

// `dmp.left leg` becomes `dmp."left leg"`.
inline std::string toml_path(std::string_view path) {
  std::string out;
  for (std::size_t start = 0; start <= path.size();) {
    const std::size_t end = std::min(path.find('.', start), path.size());
    out.append(out.empty() ? "" : ".").append(toml_key(path.substr(start, end - start)));
    start = end + 1;
  }
  return out;
}

// The shortest text that reads back as the same bits.
inline std::string exact_text(const schema& type, double value) {
  std::string text = number_text(type, value);
  if (type.single) {
    double again = 0;
    std::from_chars(text.data(), text.data() + text.size(), again);
    // The digits identify a float, but are read as a double and then rounded again, which may give another
    // float.
    if (static_cast<float>(again) != static_cast<float>(value)) text = number_text(value);
  }
  return text;
}

inline std::string toml_number(const schema& type, double value) {
  std::string text = exact_text(type, value);
  if (!type.unit.empty()) return toml_string(with_unit(std::move(text), type));
  // TOML reads `2` as an integer, and `-0` would lose its sign.
  return text.find_first_not_of("-0123456789") == text.npos ? text + ".0" : text;
}

// On one line; a table becomes an inline table.
inline std::string toml_value(const schema& type, const void* value) {
  std::string out;
  switch (type.what) {
    case kind::boolean:
      return type.integer(value) ? "true" : "false";
    case kind::integer:
      return std::to_string(type.integer(value));
    case kind::number:
      return toml_number(type, type.number(value));
    case kind::text:
      return toml_string(type.characters(value));
    case kind::choice: {
      const auto i = static_cast<std::size_t>(type.integer(value));
      return toml_string(i < type.count ? type.names[i] : "");
    }
    case kind::array:
      for (std::size_t i = 0; i < type.count; ++i)
        out.append(i ? ", " : "[").append(toml_value(*type.element, type.at(value, i)));
      return out.append("]");
    case kind::table:
      for (std::size_t i = 0; i < type.count; ++i)
        out.append(i ? ", " : "{")
            .append(toml_key(type.members[i].name))
            .append(" = ")
            .append(toml_value(*type.members[i].type, type.members[i].of(value)));
      return out.append(type.count ? "}" : "{}");
    case kind::unsupported:
      break;
  }
  return out;
}

}  // namespace cca::detail
