// Reads a number with its unit from a text, "30 deg", and converts it to the SI unit of its field.
#pragma once

#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

#include <cca/component/parameter_check.hpp>

namespace cca::detail {

// "rad, deg or mrad"
inline std::string unit_names(const unit* units) {
  std::string text(units->text.empty() ? "no unit" : units->text);
  for (std::size_t i = 1; !units[i].text.empty(); ++i)
    text.append(units[i + 1].text.empty() ? " or " : ", ").append(units[i].text);
  return text;
}

struct measured {
  double value = 0;       // in the SI unit
  std::string complaint;  // empty if it could be read
  bool converted = false;
};

inline measured measure(std::string_view text, const unit* units) {
  const auto trimmed = [](std::string_view part) {
    const auto from = part.find_first_not_of(" \t");
    return from == part.npos ? std::string_view{}
                             : part.substr(from, part.find_last_not_of(" \t") - from + 1);
  };
  // With append: `"..." + std::string` gives a false warning (docs/compilers.md).
  const std::string quoted = std::string("\"").append(text).append("\"");
  std::string_view rest = trimmed(text);
  if (rest.size() > 1 && rest[0] == '+' && rest[1] != '-') rest.remove_prefix(1);
  measured result;
  const auto read = std::from_chars(rest.data(), rest.data() + rest.size(), result.value);
  if (read.ec == std::errc::result_out_of_range) return {0, quoted + " does not fit into a double", false};
  if (read.ec != std::errc{})
    return {0, "expected a number with its unit (" + unit_names(units) + "), got a string " + quoted, false};
  const std::string_view written = trimmed(rest.substr(static_cast<std::size_t>(read.ptr - rest.data())));
  if (written.empty() && !units->text.empty())
    return {0, quoted + " has no unit, expected " + unit_names(units), false};
  for (const unit* known = units; known == units || !known->text.empty(); ++known) {
    if (known->text != written) continue;
    result.converted = known->factor != 1;
    if (result.converted) result.value *= known->factor;
    return result;
  }
  return {0, "unknown unit \"" + std::string(written) + "\" in " + quoted + ", expected " + unit_names(units),
          false};
}

}  // namespace cca::detail
