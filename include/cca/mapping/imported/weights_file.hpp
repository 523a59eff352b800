// Reads the weights of an imported policy: a text of a learned module (learned_file.hpp) with the lines of
// the contract, and the numbers.
//
//   cca learned 1
//   learner policy walk
//   contract: rate 50 Hz
//   ...
//   numbers weights 197388
//   0.1 -0.2 ...                  ten per line
//   checksum 0f3a...
//
// Refused, with file, line, what was found and what was expected: a damaged text, the weights of another
// network or contract, text that is no finite number.
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include <cca/adaptive/learned_file.hpp>

namespace cca::detail {

template <class Number>
void read_policy_weights(std::string_view text,
                         std::string_view file,
                         std::string_view name,
                         std::span<const std::string_view> contract,
                         std::span<Number> into) {
  check_learned_frame(text, file);
  learned_reader lines(text, file);
  lines.line();
  lines.expect("learner", "policy " + std::string(name),
               "these are the weights of another policy; name the file that was written with this header");
  for (const std::string_view line : contract)
    lines.expect(
        "contract:", line,
        "these weights are of another contract or training; import header and weights from one export");
  lines.expect("numbers", "weights " + std::to_string(into.size()), "the file has other numbers");
  std::string_view line;
  for (std::size_t i = 0; i < into.size(); ++i) {
    if (i % 10 == 0) line = lines.line();
    const auto one = line.substr(0, line.find(' '));
    const auto read = std::from_chars(one.data(), one.data() + one.size(), into[i]);
    if (read.ec != std::errc() || read.ptr != one.data() + one.size() || !std::isfinite(into[i]))
      lines.refuse("weights[" + std::to_string(i) + "]: expected a finite number, got `" +
                   std::string(one.substr(0, 40)) + "`");
    line.remove_prefix(std::min(one.size() + 1, line.size()));
    if ((i % 10 == 9 || i + 1 == into.size()) && !line.empty())
      lines.refuse("weights: more numbers in this line than expected");
  }
  if (!lines.line().starts_with("checksum "))
    lines.refuse("expected the checksum: the file has more numbers");
}

}  // namespace cca::detail
