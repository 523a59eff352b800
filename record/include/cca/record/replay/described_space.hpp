// What a recording says about the space of an output, in words, and where two of them differ first.
#pragma once

#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <cca/record/mcap/bytes.hpp>
#include <cca/record/mcap/printable.hpp>
#include <cca/record/messages/sample_message.hpp>

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

  described_space(const text_map& metadata, std::string_view schema) {
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
  explicit described_space(const cca::detail::space_info& of)
      : described_space(sample_metadata(of), sample_schema(of)) {}

  std::string text() const {
    std::string all = quoted(domain) + " of ";
    for (std::size_t i = 0; i < numbers.size() && i < 24; ++i)
      all.append(i ? ", " : "").append(quoted(numbers[i].name));
    return all + (numbers.size() > 24 ? ", ..." : "");
  }
  static std::string quoted(const std::string& word) {
    return word.empty() ? "none" : "`" + printable(word, 60) + "`";
  }
};

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

}  // namespace cca::recording::detail
