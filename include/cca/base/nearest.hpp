// Finds the name that the user probably meant, for messages about a name that doesn't exist.
#pragma once

#include <cca/base/compiler.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace cca::detail {

// How many letters to insert, remove, replace or swap with their neighbour. Compares the first 48 letters.
constexpr std::size_t edit_distance(std::string_view a, std::string_view b) {
  constexpr std::size_t longest = 48;
  a = a.substr(0, longest);
  b = b.substr(0, longest);
  std::array<std::array<std::size_t, longest + 1>, 3> rows{};
  for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    auto& row = rows[i % 3];
    const auto &above = rows[(i + 2) % 3], &before = rows[(i + 1) % 3];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return rows[a.size() % 3][b.size()];
}

// Empty if more than a third of the letters differ.
template <class Names>
constexpr std::string_view nearest_name(std::string_view wrong, const Names& names) {
  std::string_view best;
  std::size_t least = std::max<std::size_t>(1, wrong.size() / 3) + 1;
  for (const std::string_view name : names) {
    const std::size_t distance = edit_distance(wrong, name);
    if (distance < least) {
      least = distance;
      best = name;
    }
  }
  return best;
}

// Of paths with points between their parts: `robot.angles` means `robot.angles.whole`, which the letters
// alone would not tell.
template <class Paths>
constexpr std::string_view nearest_path(std::string_view wrong, const Paths& paths) {
  if (!wrong.empty())
    for (const std::string_view path : paths)
      if (path.size() > wrong.size() && path.starts_with(wrong) && path[wrong.size()] == '.') return path;
  return nearest_name(wrong, paths);
}

}  // namespace cca::detail
