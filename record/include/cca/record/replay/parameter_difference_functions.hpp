// The functions that say how parameters differ. parameter_difference.hpp includes this, unless they are
// compiled once for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/messages/first_words.hpp>
#include <cca/record/mcap/printable.hpp>
#include <cca/record/replay/described_space.hpp>
#include <cca/record/replay/parameter_difference.hpp>

namespace cca::recording::detail {

// A line of a schema: "float64 angle  # rad, -1 to 1", "int64 gait  # 0 walk, 1 trot", "string name".
struct parameter_line {
  std::string_view type, name, unit;
  std::vector<std::string_view> choices;

  static std::vector<parameter_line> all_of(std::string_view text) {
    std::vector<parameter_line> all;
    while (!text.empty()) {
      const auto [line, rest] = split_at(text, text.find('\n'), 1);
      text = rest;
      const auto [field, comment] = split_at(line, line.find('#'), 1);
      const auto [type, name] = split_at(trimmed(field), trimmed(field).find(' '), 1);
      if (name.empty() || name == "beat") continue;
      parameter_line& one = all.emplace_back();
      one.type = type, one.name = trimmed(name);
      std::vector<std::string_view> notes;
      for (std::string_view left = trimmed(comment); !left.empty();) {
        const auto [note, others] = split_at(left, left.find(", "), 2);
        notes.push_back(note);
        left = others;
      }
      // "2 " is a number between those of an enumeration.
      if (type == "int64")
        std::erase_if(notes, [](auto note) { return trimmed(note).find(' ') == note.npos; });
      if (type == "int64") one.choices = notes;
      else if (!notes.empty() && notes.front().find(" to ") == notes.front().npos) one.unit = notes.front();
    }
    return all;
  }
  static std::string_view trimmed(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    return text;
  }
};

inline std::string quoted_words(const std::vector<std::string_view>& words) {
  return cca::detail::first_words(words.size(), 6, ", ",
                                  [&](std::size_t i) { return "`" + printable(words[i], 60) + "`"; });
}

CCA_RECORD_INLINE std::string parameter_difference(std::string_view here, std::string_view there) {
  const auto own = parameter_line::all_of(here), recorded = parameter_line::all_of(there);
  const auto names_of = [](const std::vector<parameter_line>& all) {
    std::vector<std::string_view> names;
    for (const parameter_line& one : all) names.push_back(one.name);
    return names;
  };
  const auto missing_in = [](const std::vector<std::string_view>& names, std::vector<std::string_view> from) {
    std::erase_if(from, [&](std::string_view name) { return std::ranges::find(names, name) != names.end(); });
    return from;
  };
  const auto names = names_of(own), recorded_names = names_of(recorded);
  const auto new_ones = missing_in(recorded_names, names), old_ones = missing_in(names, recorded_names);
  std::string text;
  if (!new_ones.empty()) text = "the recording lacks " + quoted_words(new_ones);
  if (!old_ones.empty())
    text.append(text.empty() ? "" : ", and ")
        .append(quoted_words(old_ones) + (old_ones.size() > 1 ? " are" : " is") + " only in the recording");
  if (!text.empty()) return text;
  if (names != recorded_names)
    return "they are in another order: here " + quoted_words(names) + ", in the recording " +
           quoted_words(recorded_names);
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto differ = [&](const std::string& what, const std::string& a, const std::string& b) {
      return what + quoted_words({own[i].name}) + ": here " + a + ", in the recording " + b;
    };
    if (own[i].type != recorded[i].type)
      return differ("another type of ", quoted_words({own[i].type}), quoted_words({recorded[i].type}));
    if (own[i].unit != recorded[i].unit && !own[i].unit.empty() && !recorded[i].unit.empty())
      return differ("another unit of ", quoted_words({own[i].unit}), quoted_words({recorded[i].unit}));
    // A choice more or less changes no number of the others.
    for (const std::string_view a : own[i].choices)
      for (const std::string_view b : recorded[i].choices) {
        const auto [number, name] = split_at(a, a.find(' '), 1);
        const auto [recorded_number, recorded_name] = split_at(b, b.find(' '), 1);
        if ((number == recorded_number) != (name == recorded_name))
          return differ("other choices of ", quoted_words(own[i].choices), quoted_words(recorded[i].choices));
      }
  }
  return {};
}

}  // namespace cca::recording::detail
