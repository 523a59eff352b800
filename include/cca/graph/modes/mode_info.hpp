// A set of modes as values.
#pragma once

#include <string_view>

#include <cca/graph/plan/flat.hpp>

namespace cca::detail {

struct mode_info {
  std::string_view name{};
  std::string_view type{};                                      // of its graph, or of an item that is no mode
  ref<flat_view> plan = nullptr;                                // of its graph; null: it has none
  bool is_mode = false, is_deployment = false, is_set = false;  // a set of modes again
};

// What a set of modes hangs on its plan.
struct modes_info : hung_facts {
  constexpr modes_info(std::string_view set, const mode_info* all, int number, bool checked)
      : name(set), modes(all), count(number), is_checked(checked) {}

  std::string_view name;
  const mode_info* modes;
  int count;
  bool is_checked;  // it is the same set once more, of a deployment

  constexpr int number_of(std::string_view mode) const {
    for (int m = 0; m < count; ++m)
      if (modes[m].name == mode) return m;
    return -1;
  }
};

constexpr const modes_info& modes_in_plan(const flat_view& g) {
  return static_cast<const modes_info&>(*g.hung);
}

// A bit for each mode that has a node or a queue.
using mode_set = std::uint64_t;
inline constexpr int most_modes = 64;

constexpr mode_set bit_of(int mode) { return mode_set{1} << mode; }
constexpr bool has_mode(mode_set modes, int mode) { return (modes & bit_of(mode)) != 0; }

constexpr mode_set all_of_modes(const modes_info& all) {
  mode_set set = 0;
  for (int m = 0; m < all.count; ++m) set |= bit_of(m);
  return set;
}

// The first mode of a set.
constexpr int first_of(mode_set modes) {
  int mode = 0;
  while (mode < most_modes - 1 && !has_mode(modes, mode)) ++mode;
  return mode;
}

}  // namespace cca::detail
