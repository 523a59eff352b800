// What a module has learned, as text. It needs no library to read, and each number comes back bit for bit.
//
//   cca learned 1                          version of the format
//   model rhythmic_shape over hip, knee with 25 functions
//   learner locally_weighted_regression
//   constant stiffness 25                  a value that must be the same as during learning
//   input angles: joint_angles at 50 Hz    of a policy: a port that it was made for (policy.hpp)
//   numbers function.weights 50
//   0.1 0.2 ...                            ten per line
//   checksum 0f3a...                       of everything above: FNV-1a, 64 bits
//
// Refused, with file, line, what was found and what was expected: another version, a damaged text, another
// model, learner or constant, text that is no finite number. All or nothing: the values are read into a copy.
// docs/decisions/0010-learned-file.md says why not TOML.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/math/roots.hpp>
#include <cca/component/parameter_check.hpp>
#include <cca/base/refused.hpp>
#include <cca/component/schema.hpp>
#include <cca/base/fixed_string.hpp>

namespace cca {

// The model, the learner, and the constants that the numbers also depend on.
struct learned_header {
  std::string model, learner;
  struct constant {
    std::string_view name;
    double value;
  };
  std::vector<constant> constants{};
  // What the numbers were learned for: "input angles", and lines that describe it.
  struct port {
    std::string name;
    std::vector<std::string> lines;
  };
  std::vector<port> ports{};
};

namespace detail {

inline constexpr std::string_view learned_format = "cca learned 1";

// Calls f(name, schema, address) for each field of a struct, including those of inner structs.
template <class F>
void each_field(const schema& type, const void* values, const std::string& path, F& f) {
  for (std::size_t i = 0; i < type.count; ++i) {
    const member& one = type.members[i];
    const std::string name = path.empty() ? std::string(one.name) : path + "." + std::string(one.name);
    const void* at = one.of(values);
    if (one.type->what == kind::table) each_field(*one.type, at, name, f);
    else f(name, *one.type, at);
  }
}

template <class F>
void each_number(const schema& type, const void* at, F& f) {
  if (type.what == kind::array)
    for (std::size_t i = 0; i < type.count; ++i) each_number(*type.element, type.at(at, i), f);
  else if (type.what == kind::table)
    for (std::size_t i = 0; i < type.count; ++i)
      each_number(*type.members[i].type, type.members[i].of(at), f);
  else f(type, at);
}

inline std::size_t number_count(const schema& type, const void* at) {
  std::size_t count = 0;
  auto add = [&](const schema&, const void*) { ++count; };
  each_number(type, at, add);
  return count;
}

inline std::string hash_text(std::uint64_t hash) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string written;
  for (int shift = 60; shift >= 0; shift -= 4) written.push_back(digits[hash >> shift & 15]);
  return written;
}
inline std::string checksum_of(std::string_view text) { return hash_text(hash(text)); }

inline std::string learned_number_text(const schema& type, const void* at) {
  return type.number ? number_text(type.number(at)) : std::to_string(type.integer(at));
}

// What is wrong with the text of a number; empty: it is set.
inline std::string read_learned_number(const schema& type, void* into, std::string_view text) {
  const char* const begin = text.data();
  const char* const end = begin + text.size();
  const auto got = [&] { return ", got `" + std::string(text.substr(0, 40)) + "`"; };
  double value = 0;
  if (const auto read = std::from_chars(begin, end, value);
      read.ec != std::errc() || read.ptr != end || !std::isfinite(value))
    return "expected a finite number" + got();
  if (type.number) {
    auto wrong = number_complaint(type, value, std::string(text.substr(0, 40)));
    if (wrong.empty()) type.set_number(into, value);
    return wrong;
  }
  std::int64_t whole = 0;
  if (const auto read = std::from_chars(begin, end, whole); read.ec != std::errc() || read.ptr != end) {
    // Older files have an integer as a double, 1e+05, which is exact up to here.
    if (std::abs(value) > 0x1p53 || math::trunc(value) != value) return "expected an integer" + got();
    whole = static_cast<std::int64_t>(value);
  }
  if (type.what == kind::integer) {
    if (auto wrong = integer_complaint(type, whole); !wrong.empty()) return wrong;
  } else if (const auto end_of_names = static_cast<std::int64_t>(type.what == kind::choice ? type.count : 2);
             whole < 0 || whole >= end_of_names) {
    return "expected " + (type.what == kind::choice ? "the number of " + names_text(type) : "0 or 1") + got();
  }
  type.set_integer(into, whole);
  return {};
}

inline std::string learned_text(const learned_header& header, const schema& type, const void* values) {
  std::string text(learned_format);
  text.append("\nmodel ").append(header.model).append("\nlearner ").append(header.learner).append("\n");
  for (const auto& one : header.constants)
    text.append("constant ").append(one.name).append(" ").append(number_text(one.value)).append("\n");
  for (const auto& port : header.ports)
    for (const auto& line : port.lines) text.append(port.name).append(": ").append(line).append("\n");
  auto field = [&](const std::string& name, const schema& what, const void* at) {
    text.append("numbers ")
        .append(name)
        .append(" ")
        .append(std::to_string(number_count(what, at)))
        .append("\n");
    std::size_t written = 0;
    auto number = [&](const schema& one, const void* where) {
      text.append(written % 10 == 0 ? "" : " ").append(learned_number_text(one, where));
      if (++written % 10 == 0) text.append("\n");
    };
    each_number(what, at, number);
    if (written % 10 != 0) text.append("\n");
  };
  each_field(type, values, "", field);
  return text + "checksum " + checksum_of(text) + "\n";
}

// Reads the text line by line; its refusals name the file and the line.
class learned_reader {
public:
  learned_reader(std::string_view text, std::string_view file) : rest(text), name(file) {}

  std::string_view line() {
    ++number;
    const auto end = rest.find('\n');
    const auto found = rest.substr(0, end);
    rest.remove_prefix(end == rest.npos ? rest.size() : end + 1);
    return found;
  }
  [[noreturn]] void refuse(const std::string& what) const {
    throw refused(std::string(name) + ":" + std::to_string(number) + ": " + what);
  }

  void expect(std::string_view key, std::string_view value, const std::string& why) {
    const auto found = line();
    const std::string wanted = std::string(key) + " " + std::string(value);
    if (found != wanted)
      refuse(why + ": found `" + std::string(found.substr(0, 200)) + "`, expected `" + wanted + "`");
  }

private:
  std::string_view rest, name;
  int number = 0;
};

inline void check_learned_frame(std::string_view text, std::string_view file) {
  learned_reader lines(text, file);
  const auto first = lines.line();
  if (!first.starts_with("cca learned "))
    lines.refuse("this is not a file of a learned module: it begins with `" +
                 std::string(first.substr(0, 40)) + "`, expected `" + std::string(learned_format) + "`");
  if (first != learned_format)
    lines.refuse("the file has another version of the format: `" + std::string(first) + "`, expected `" +
                 std::string(learned_format) +
                 "`; learn again, or read it with the version of cca that wrote it");
  const auto last = text.rfind("checksum ");
  const std::string right = last == text.npos ? "" : "checksum " + checksum_of(text.substr(0, last)) + "\n";
  if (last == text.npos) throw refused(std::string(file) + ": damaged: the checksum is missing at its end");
  if (text.substr(last) != right)
    throw refused(std::string(file) + ": damaged: it ends with `" +
                  std::string(text.substr(last, 40)).substr(0, 25) + "`, expected `" + right.substr(0, 25) +
                  "` for this text");
}

// Reads into `values` of this schema. A refusal may leave some of them changed: pass a copy.
inline void read_learned(std::string_view text,
                         std::string_view file,
                         const learned_header& header,
                         const schema& type,
                         void* values) {
  check_learned_frame(text, file);
  learned_reader lines(text, file);
  lines.line();
  lines.expect("model", header.model,
               "the file belongs to another model; name the file of this one, or learn again");
  lines.expect("learner", header.learner,
               "the file belongs to another learner; name the file of this one, or learn again");
  for (const auto& one : header.constants)
    lines.expect("constant", std::string(one.name) + " " + number_text(one.value),
                 "it was learned with another value; set the old value, or learn again");
  for (const auto& port : header.ports)
    for (const auto& line : port.lines)
      lines.expect(
          port.name + ":", line,
          "the file was made for another `" + port.name + "`; wire the one of the file, or learn again");
  auto field = [&](const std::string& name, const schema& what, const void* at) {
    const std::size_t count = number_count(what, at);
    lines.expect("numbers", name + " " + std::to_string(count), "the file has other fields");
    std::string_view line;
    std::size_t done = 0;
    auto number = [&](const schema& one, const void* where) {
      if (done % 10 == 0) line = lines.line();
      const auto text_of_number = line.substr(0, line.find(' '));
      line.remove_prefix(std::min(text_of_number.size() + 1, line.size()));
      if (const auto wrong = read_learned_number(one, const_cast<void*>(where), text_of_number);
          !wrong.empty())
        lines.refuse(name + "[" + std::to_string(done) + "]: " + wrong);
      if (++done % 10 == 0 || done == count)
        if (!line.empty()) lines.refuse(name + ": more numbers in this line than expected");
    };
    each_number(what, at, number);
  };
  each_field(type, values, "", field);
  if (!lines.line().starts_with("checksum ")) lines.refuse("expected the checksum: the file has more fields");
  std::vector<complaint> wrong;
  check(type, values, "", wrong);
  if (!wrong.empty())
    throw refused(std::string(file) + ": " + wrong.front().path + ": " + wrong.front().what);
}

}  // namespace detail
}  // namespace cca
