// What the options of descriptions write and print. descriptions.hpp includes this, unless they are
// compiled once for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/base/messages/first_words.hpp>
#include <cca/base/file.hpp>
#include <cca/main/descriptions.hpp>
#include <cca/space/space_schema.hpp>

namespace cca::detail {

// A word for each number of a space, or for the first ones.
template <class WordOf>
std::string words_of_numbers(const space_schema& all, WordOf word_of) {
  return first_words(static_cast<std::size_t>(all.field_count()), 16, " ",
                     [&](std::size_t i) { return word_of(static_cast<int>(i)); });
}

// "rad", or one unit for each number: "m m m 1 1 1 1".
inline std::string units_text(const space_schema& all) {
  const auto unit = [&](int i) {
    const std::string_view stated = all.field(i).unit;
    return std::string(stated.empty() ? "1" : stated);
  };
  bool is_same = true;
  for (int i = 1; i < all.field_count(); ++i) is_same = is_same && unit(i) == unit(0);
  return is_same ? unit(0) : words_of_numbers(all, unit);
}

// The names of its numbers, or how many there are.
inline std::string numbers_text(const space_schema& all) {
  if (!all.has_names())
    return std::to_string(all.field_count()) + (all.field_count() == 1 ? " number" : " numbers");
  return words_of_numbers(all, [&](int i) { return std::string(all.field(i).name()); });
}

inline std::string rate_text(const space_info& space) {
  std::ostringstream text;
  if (space.hz > 0) text << space.hz << " Hz";
  else text << '-';
  return text.str();
}

// Columns. An entry of more than 40 letters is not aligned with.
inline std::string in_columns(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> width;
  for (const auto& row : rows) {
    width.resize(std::max(width.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i)
      if (row[i].size() <= 40) width[i] = std::max(width[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line.append(std::max(width[i], row[i].size()) + 2 - row[i].size(), ' ');
    }
    text += line + '\n';
  }
  return text;
}

CCA_MAIN_INLINE std::string list_of_outputs(const std::vector<listed_output>& outputs) {
  std::vector<std::vector<std::string>> rows{{"output", "space", "unit", "rate", "numbers"}};
  for (const auto& [path, space] : outputs) {
    const space_schema all(*space);
    rows.push_back({path, std::string(space->name), units_text(all), rate_text(*space), numbers_text(all)});
  }
  return in_columns(rows);
}

CCA_MAIN_INLINE void offer_descriptions(command_line& line,
                                        std::function<std::string(const std::string&)> parameters,
                                        std::string (*outputs)()) {
  line.instead(
      "--write-parameters FILE",
      [parameters = std::move(parameters)](const std::string& file) {
        if (file.empty()) throw command_line_error("--write-parameters: expected the name of a file");
        write_file(file, "# All parameters, as a run begins with them. --config reads this file.\n\n" +
                             parameters(file));
        return 0;
      },
      "writes all parameters, with units and ranges, for --config; nothing runs");
  line.instead(
      "--list",
      [outputs](const std::string&) {
        std::cout << outputs();
        return 0;
      },
      "prints all outputs, with space, unit and rate; nothing runs");
}

}  // namespace cca::detail
