// The functions that say where two architectures differ. architecture_difference.hpp includes this, unless
// they are compiled once for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <cca/record/mcap/printable.hpp>
#include <cca/record/replay/architecture_difference.hpp>
#include <cca/record/replay/described_space.hpp>
#include <cca/runtime/transports/manifest.hpp>

namespace cca::recording::detail {

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

// A line "wire to limits.command from output 1, delayed 0": what stands before "from", the number, the rest.
struct wire_line {
  std::string_view to, rest;
  std::size_t output = 0;

  static std::optional<wire_line> of(std::string_view line) {
    wire_line one;
    constexpr std::string_view begin = "wire to ", from = " from output ";
    const auto at = line.rfind(from);
    if (!line.starts_with(begin) || at == line.npos) return {};
    one.to = line.substr(0, at);
    const std::string_view number = line.substr(at + from.size());
    const char *const first = number.data(), *const last = first + number.size();
    const auto [to, error] = std::from_chars(first, last, one.output);
    if (error != std::errc()) return {};
    one.rest = {to, last};
    return one;
  }
};

// With the name of the output in each line of a wire: the number counts the lines of outputs, of a set of
// modes those of the same mode.
inline std::string with_writers(std::string_view text) {
  std::string all;
  std::vector<std::string_view> outputs;
  while (!text.empty()) {
    const auto [line, rest] = split_at(text, text.find('\n'), 1);
    text = rest;
    if (line.starts_with("mode ")) outputs.clear();
    if (const auto output = output_line::of(line)) outputs.push_back(output->port);
    if (const auto wire = wire_line::of(line); wire && wire->output < outputs.size())
      all.append(wire->to).append(" from ").append(outputs[wire->output]).append(wire->rest);
    else all += line;
    all += '\n';
  }
  return all;
}

CCA_RECORD_INLINE std::string architecture_difference(std::string_view here,
                                                      std::string_view there,
                                                      const spaces_by_hash& spaces,
                                                      const mcap_reader& file) {
  std::string lines = printable(cca::detail::first_difference(with_writers(here), with_writers(there)), 2000);
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
           "; the recording has no topic with that output's " + printable(recorded->numbers, 20) +
           " numbers, so it does not say what they are";
  }
  return lines;
}

}  // namespace cca::recording::detail
