// The values of a network while it is read: constants with their numbers, or names of variables in the text.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "network.hpp"
#include "onnx.hpp"

namespace cca_policy {

using shape = std::vector<std::int64_t>;
using places = std::vector<std::int64_t>;  // flat indices

inline constexpr std::int64_t most_computed = 1 << 16;  // numbers of a value that is computed

struct value {
  shape dims;
  bool is_constant = false, is_whole = false;
  std::vector<double> numbers;  // of a constant; integers too
  std::string variable;         // of what is computed
  std::int64_t count() const { return count_of(dims); }
};

inline std::string in_words(const shape& dims) {
  std::string all;
  for (const std::int64_t d : dims) all += (all.empty() ? "" : " x ") + std::to_string(d);
  return all.empty() ? "one number" : all;
}

// The dimensions that are not one: a batch and other ones count for nothing.
inline shape without_ones(const shape& dims) {
  shape kept;
  for (const std::int64_t d : dims)
    if (d != 1) kept.push_back(d);
  return kept;
}

inline std::int64_t product_of(const shape& dims, std::size_t from, std::size_t to) {
  return count_of(shape(dims.begin() + static_cast<std::ptrdiff_t>(from),
                        dims.begin() + static_cast<std::ptrdiff_t>(to)));
}

// An axis of an operator, where negative ones count from the end.
inline std::size_t axis_of(std::int64_t axis, std::size_t rank, const std::string& what) {
  const std::int64_t at = axis < 0 ? axis + static_cast<std::int64_t>(rank) : axis;
  if (at < 0 || at >= static_cast<std::int64_t>(rank))
    refuse(what + " has the axis " + std::to_string(axis) + " of " + std::to_string(rank));
  return static_cast<std::size_t>(at);
}

// The flat places of what an axis keeps.
inline places along(const shape& dims, std::size_t axis, const places& kept) {
  const std::int64_t outer = product_of(dims, 0, axis), inner = product_of(dims, axis + 1, dims.size());
  if (outer < 0 || inner < 0 ||
      (inner > 0 && outer > most_numbers / inner / static_cast<std::int64_t>(kept.size() + 1)))
    refuse("a value is too large");
  places all;
  for (std::int64_t o = 0; o < outer; ++o)
    for (const std::int64_t k : kept)
      for (std::int64_t i = 0; i < inner; ++i) all.push_back((o * dims[axis] + k) * inner + i);
  return all;
}

}  // namespace cca_policy
