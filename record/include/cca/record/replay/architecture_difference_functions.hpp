// The functions that say where two architectures differ. architecture_difference.hpp includes this, unless
// they are compiled once for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include <cca/record/messages/sample_message.hpp>
#include <cca/record/replay/architecture_difference.hpp>
#include <cca/runtime/transports/manifest.hpp>

namespace cca::recording::detail {

// What is before and after a separator of this size; if there is none, all is before.
using two_texts = std::pair<std::string_view, std::string_view>;
inline two_texts split_at(std::string_view text, std::size_t at, std::size_t size) {
  return at == text.npos ? two_texts{text, {}} : two_texts{text.substr(0, at), text.substr(at + size)};
}

// What the schema and the metadata of a topic say about its space.
struct described_space {
  struct number {
    std::string name, unit, limits;  // empty: none
  };
  std::string domain, frame, rate;
  std::vector<number> numbers;

  described_space(const text_map& metadata, std::string_view schema);
  explicit described_space(const cca::detail::space_info& of)
      : described_space(sample_metadata(of), sample_schema(of)) {}

  std::string text() const;
  static std::string quoted(const std::string& word);
};

// A line "output s.y: 2 numbers, space 15408129297789867146" of an architecture.
struct output_line {
  std::string_view port, numbers;
  std::uint64_t hash = 0;

  static std::optional<output_line> of(std::string_view line) {
    output_line one;
    constexpr std::string_view begin = "output ", middle = ": ", space = " numbers, space ";
    const auto at = line.rfind(middle), end = line.rfind(space);
    if (!line.starts_with(begin) || at == line.npos || end == line.npos || end < at + middle.size())
      return {};
    one.port = line.substr(begin.size(), at - begin.size());
    one.numbers = line.substr(at + middle.size(), end - at - middle.size());
    const std::string_view digits = line.substr(end + space.size());
    const char *const first = digits.data(), *const last = first + digits.size();
    const auto [to, error] = std::from_chars(first, last, one.hash);
    if (error != std::errc() || to != last) return {};
    return one;
  }
};

inline described_space::described_space(const text_map& metadata, std::string_view schema) {
  const auto entry = [&](const char* name) {
    const auto found = metadata.find(name);
    return found == metadata.end() ? std::string() : found->second;
  };
  frame = entry("frame");
  rate = entry("rate_hz");
  domain = entry("domain");
  if (!frame.empty()) domain = domain.substr(0, domain.find('<'));
  // "float64 hip  # rad, -0.9 to 0.9": each of unit and limits may be missing.
  while (!schema.empty()) {
    const auto [line, rest] = split_at(schema, schema.find('\n'), 1);
    schema = rest;
    if (!line.starts_with("float64 ")) continue;
    const auto [name, comment] = split_at(line.substr(8), line.substr(8).find("  # "), 4);
    number& n = numbers.emplace_back();
    n.name = name;
    if (comment.find(" to ") == comment.npos) n.unit = comment;
    else if (comment.find(", ") == comment.npos) n.limits = comment;
    else std::tie(n.unit, n.limits) = split_at(comment, comment.rfind(", "), 2);
  }
}

inline std::string described_space::text() const {
  std::string all = quoted(domain) + " of ";
  for (std::size_t i = 0; i < numbers.size() && i < 24; ++i)
    all.append(i ? ", " : "").append(quoted(numbers[i].name));
  return all + (numbers.size() > 24 ? ", ..." : "");
}

inline std::string described_space::quoted(const std::string& word) {
  return word.empty() ? "none" : "`" + word.substr(0, 60) + "`";
}

// "another axis 2: here `cz`, in the recording `cy`"
inline std::string difference_of(const described_space& here, const described_space& there) {
  const auto differ = [](const std::string& what, const std::string& a, const std::string& b) {
    return what + ": here " + described_space::quoted(a) + ", in the recording " + described_space::quoted(b);
  };
  if (here.domain != there.domain) return differ("another domain type", here.domain, there.domain);
  if (here.frame != there.frame) return differ("another frame", here.frame, there.frame);
  for (std::size_t i = 0; i < here.numbers.size() || i < there.numbers.size(); ++i) {
    const described_space::number none;
    const auto& a = i < here.numbers.size() ? here.numbers[i] : none;
    const auto& b = i < there.numbers.size() ? there.numbers[i] : none;
    if (a.name != b.name)
      return differ("another axis " + std::to_string(i + 1), a.name, b.name) + "; here it is " + here.text() +
             ", in the recording " + there.text();
    const std::string of_axis = " of the axis " + described_space::quoted(a.name);
    if (a.unit != b.unit) return differ("another unit" + of_axis, a.unit, b.unit);
    if (a.limits != b.limits) return differ("other limits" + of_axis, a.limits, b.limits);
  }
  if (here.rate != there.rate) return differ("another rate in Hz", here.rate, there.rate);
  return "other limits or another rate, but only after the sixth digit, which is the last one in the file";
}

CCA_RECORD_INLINE std::string architecture_difference(std::string_view here,
                                                      std::string_view there,
                                                      const spaces_by_hash& spaces,
                                                      const mcap_reader& file) {
  std::string lines = cca::detail::first_difference(here, there);
  std::string_view in_mode;
  while (!here.empty() && !there.empty()) {
    const auto [a, rest_here] = split_at(here, here.find('\n'), 1);
    const auto [b, rest_there] = split_at(there, there.find('\n'), 1);
    here = rest_here, there = rest_there;
    if (a == b) {
      if (a.starts_with("mode ")) in_mode = a.substr(5);
      continue;
    }
    const auto own = output_line::of(a), recorded = output_line::of(b);
    if (!own || !recorded || own->port != recorded->port) return lines;
    const auto space = spaces.find(own->hash);
    if (space == spaces.end()) return lines;
    const described_space known(*space->second);
    const std::string output = "the output `" + std::string(own->port) + "`" +
                               (in_mode.empty() ? "" : " of mode `" + std::string(in_mode) + "`") + " has ";
    for (const auto& [id, channel] : file.channels()) {
      const auto hash = channel.metadata.find("schema_hash");
      const auto schema = file.schemas().find(channel.schema);
      if (hash != channel.metadata.end() && hash->second == std::to_string(recorded->hash) &&
          schema != file.schemas().end())
        return output + difference_of(known, described_space(channel.metadata, schema->second.text));
    }
    return output + "another space: here " + known.text() +
           "; the recording has no topic with that output's " + std::string(recorded->numbers.substr(0, 20)) +
           " numbers, so it does not say what they are";
  }
  return lines;
}

}  // namespace cca::recording::detail
