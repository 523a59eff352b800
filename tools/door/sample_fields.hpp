// The fields of a message, read by the schema that a door states: `ros2msg`, the messages are CDR.
//
// The schema comes from another program, so nothing here trusts it: what it can't be read with is not read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/record/messages/cdr.hpp>

#include "members.hpp"

namespace cca_door {

class message_schema {
public:
  struct field {
    std::string name{}, type{}, unit{};
    bool is_array = false;
    std::size_t count = 0;  // of an array of fixed size; 0: its length is in the message
  };

  explicit message_schema(std::string_view text) {
    std::string name;  // of the message itself
    while (!text.empty()) {
      const std::string_view line = text.substr(0, text.find('\n'));
      text.remove_prefix(std::min(text.size(), line.size() + 1));
      if (line.starts_with("===")) continue;
      if (line.starts_with("MSG: ")) name = short_name(line.substr(5));
      else add(name, line);
    }
  }

  // Of the message itself, in order.
  const std::vector<field>& fields() const {
    static const std::vector<field> none;
    const auto found = types.find({});
    return found == types.end() ? none : found->second;
  }
  // The samples of an output have the beat and the time of origin first; what else is recorded has not.
  bool is_of_output() const {
    return fields().size() >= 2 && fields()[0].name == "beat" && fields()[1].name == "origin";
  }

  // An object with all fields, those of inner messages in objects. Empty: the bytes do not fit.
  std::optional<nlohmann::ordered_json> read(std::string_view bytes) const {
    cca::recording::detail::cdr_reader from(
        {reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
    auto all = message({}, from, 0);
    if (from.is_bad() || !all.is_object()) return {};
    return all;
  }

private:
  using reader = cca::recording::detail::cdr_reader;
  using value = nlohmann::ordered_json;
  static constexpr std::size_t most_elements = 1 << 16;
  static constexpr int most_depth = 8;

  // `geometry_msgs/Point` and `geometry_msgs/msg/Point` are one.
  static std::string short_name(std::string_view name) {
    std::string text(name.substr(0, name.find_last_not_of(" \r") + 1));
    if (const auto at = text.find("/msg/"); at != text.npos) text.erase(at, 4);
    return text;
  }

  void add(const std::string& message, std::string_view line) {
    const std::size_t hash = line.find('#');
    const std::string_view comment = hash == line.npos ? std::string_view() : line.substr(hash + 1);
    line = line.substr(0, hash);
    const auto word = [&line] {
      line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
      const std::string_view one = line.substr(0, line.find_first_of(" \t\r"));
      line.remove_prefix(one.size());
      return one;
    };
    const std::string_view type = word(), name = word();
    if (type.empty() || name.empty() || name.find('=') != name.npos || word().starts_with('='))
      return;  // a constant
    field f{.name = std::string(name), .type = short_name(type)};
    if (const std::size_t open = f.type.find('['); open != f.type.npos) {
      f.is_array = true;
      const std::string length = f.type.substr(open + 1, f.type.find(']') - open - 1);
      if (!length.starts_with("<="))
        for (const char c : length)
          if (c >= '0' && c <= '9' && f.count < most_elements)
            f.count = 10 * f.count + static_cast<std::size_t>(c - '0');
      f.type = f.type.substr(0, open);
    }
    if (f.type.starts_with("string<=")) f.type = "string";
    // `# rad, -0.9 to 0.9`: the unit is before the comma; `# 0 walk, 1 trot` are choices, `# 0 to 1` a range.
    const std::size_t first = comment.find_first_not_of(' ');
    if (first != comment.npos && (comment[first] < '0' || comment[first] > '9') && comment[first] != '-')
      f.unit = std::string(comment.substr(first, comment.find(',') - first));
    types[message].push_back(std::move(f));
  }

  value message(const std::string& type, reader& from, int depth) const {
    const auto found = types.find(type);
    if (found == types.end() || depth > most_depth) return {};
    value all = value::object();
    for (const field& f : found->second) {
      value one = f.is_array ? array(f, from, depth) : single(f.type, from, depth);
      if (one.is_discarded() || from.is_bad()) return {};
      all[f.name] = std::move(one);
    }
    return all;
  }
  value array(const field& f, reader& from, int depth) const {
    const std::size_t count = f.count > 0 ? f.count : from.number<std::uint32_t>();
    value all = value::array();
    if (count > most_elements) return value(value::value_t::discarded);
    for (std::size_t i = 0; i < count; ++i) {
      all.push_back(single(f.type, from, depth));
      if (all.back().is_discarded() || from.is_bad()) return value(value::value_t::discarded);
    }
    return all;
  }
  value single(const std::string& type, reader& from, int depth) const {
    if (type == "bool") return from.number<std::uint8_t>() != 0;
    if (type == "byte" || type == "char" || type == "uint8") return from.number<std::uint8_t>();
    if (type == "int8") return from.number<std::int8_t>();
    if (type == "int16") return from.number<std::int16_t>();
    if (type == "uint16") return from.number<std::uint16_t>();
    if (type == "int32") return from.number<std::int32_t>();
    if (type == "uint32") return from.number<std::uint32_t>();
    if (type == "int64") return from.number<std::int64_t>();
    if (type == "uint64") return from.number<std::uint64_t>();
    if (type == "float32") return from.number<float>();
    if (type == "float64") return from.number<double>();
    if (type == "string") return std::string(from.text());
    value inner = message(type, from, depth + 1);
    return inner.is_object() && !inner.empty() ? inner : value(value::value_t::discarded);
  }

  std::map<std::string, std::vector<field>> types{};
};

}  // namespace cca_door
