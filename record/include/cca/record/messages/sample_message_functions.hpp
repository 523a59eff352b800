// The functions that describe a sample as a message. sample_message.hpp includes this, unless they are
// compiled once for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include <cca/record/messages/sample_message.hpp>
#include <cca/space/space_schema.hpp>

namespace cca::recording::detail {

CCA_RECORD_INLINE std::string field_name(std::string_view wanted, std::set<std::string>& taken) {
  std::string name;
  for (const char c : wanted) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool is_digit = c >= '0' && c <= '9';
    if (name.empty() && !is_letter) name = "v";
    name += is_letter || is_digit ? c : '_';
  }
  while (name.ends_with('_')) name.pop_back();
  if (name.empty()) name = "v";
  std::string unique = name;
  for (int n = 2; !taken.insert(unique).second; ++n) unique = name + "_" + std::to_string(n);
  return unique;
}

CCA_RECORD_INLINE std::string sample_schema(const cca::detail::space_info& of) {
  const space_schema space(of);
  std::set<std::string> taken{"beat", "origin"};
  std::ostringstream text;
  text << "int64 beat\nint64 origin  # ns\n";
  for (int i = 0; i < space.field_count(); ++i) {
    const schema_field f = space.field(i);
    text << "float64 " << field_name(f.name(), taken);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const bool has_limits = f.lower > -infinity || f.upper < infinity;
    if (!f.unit.empty() || has_limits) text << "  #";
    if (!f.unit.empty()) text << ' ' << f.unit;
    if (has_limits) text << (f.unit.empty() ? " " : ", ") << f.lower << " to " << f.upper;
    text << '\n';
  }
  return text.str();
}

CCA_RECORD_INLINE text_map sample_metadata(const cca::detail::space_info& of) {
  const space_schema space(of);
  std::set<std::string> taken{"beat", "origin"};
  std::string axes, units;
  for (int i = 0; i < space.field_count(); ++i) {
    const schema_field f = space.field(i);
    axes.append(i ? " " : "").append(field_name(f.name(), taken));
    units.append(i ? " " : "").append(f.unit.empty() ? "1" : std::string(f.unit));
  }
  text_map all{{"space", std::string(of.name)},
               {"domain", std::string(of.domain)},
               {"axes", axes},
               {"units", units},
               {"schema_hash", std::to_string(space.hash())}};
  const auto open = of.domain.find('<'), end = of.domain.rfind('>');
  if (open != of.domain.npos && end != of.domain.npos && open < end)
    all["frame"] = of.domain.substr(open + 1, end - open - 1);
  if (of.hz > 0) {
    std::ostringstream rate;
    rate << of.hz;
    all["rate_hz"] = rate.str();
  }
  return all;
}

CCA_RECORD_INLINE std::string message_type(std::string_view space) {
  std::set<std::string> none;
  return "cca/msg/" + field_name(space, none);
}

CCA_RECORD_INLINE std::string topic_of(std::string_view path) {
  std::string topic = "/";
  for (const char c : path) topic += c == '.' ? '/' : c;
  return topic;
}

}  // namespace cca::recording::detail
