// What the checks need to know about a space, as a value: constexpr functions compare it and messages print
// it.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <cca/space/limits.hpp>
#include <cca/space/space.hpp>
#include <cca/base/type_name.hpp>

namespace cca::detail {

struct space_info {
  std::string_view name;
  std::string_view domain;
  const std::string_view* axes;
  int axis_count;
  int size;
  const double* zero;  // coordinates of the space's zero
  double hz;           // 0 if the space states no rate
  std::uint64_t key;   // equal if the domain type (with its frame) and the ordered axes are equal; 0 fits all
  bool actuated;
  int duplicate_axis;          // index, or -1
  int missing_limits;          // index of the first axis without limits for the domain's quantity, or -1
  bool missing_is_continuous;  // that axis is continuous, and its angle needs limits of velocity
  std::string_view quantity;
  const double *lower,
      *upper;  // limits of that quantity, one per axis; infinite if an axis states none

  // For messages to other programs (space_schema.hpp).
  const std::string_view* labels;  // the axes' own names
  std::string_view unit;           // of the quantity; empty if it has none
  const std::string_view *coordinates,
      *coordinate_units;  // null, or as the domain type names its numbers

  // All numbers that a sample can hold, where the space states them: `static constexpr std::array only{...}`.
  const double* only = nullptr;
  int only_count = 0;
};

// The axis `hip` of element 2 of an array is a type `element<hip, 2>`, and its own name is "hip2".
template <class Axis>
constexpr std::string_view label_of() {
  if constexpr (Dimension<Axis>) return Axis::name;
  else return type_name<Axis>();
}

template <class Quantity>
constexpr std::string_view unit_of() {
  if constexpr (requires { std::string_view(Quantity::unit); }) return Quantity::unit;
  else return {};
}

template <class Domain>
constexpr const std::string_view* coordinates_of() {
  if constexpr (requires { Domain::coordinates.data(); }) return Domain::coordinates.data();
  else return nullptr;
}

template <class Domain>
constexpr const std::string_view* coordinate_units_of() {
  if constexpr (requires { Domain::coordinate_units.data(); }) return Domain::coordinate_units.data();
  else return nullptr;
}

template <class Space>
constexpr const double* only_of() {
  if constexpr (requires { Space::only.data(); }) return Space::only.data();
  else return nullptr;
}
template <class Space>
constexpr int only_count_of() {
  if constexpr (requires { Space::only.size(); }) return static_cast<int>(Space::only.size());
  else return 0;
}

template <class Axes>
struct axes_facts;

template <class... Axes>
struct axes_facts<axes<Axes...>> {
  static constexpr std::array<std::string_view, sizeof...(Axes) + 1> names{type_name<Axes>()..., {}};
  static constexpr std::array<std::string_view, sizeof...(Axes) + 1> labels{label_of<Axes>()..., {}};

  static constexpr std::uint64_t key(std::uint64_t seed) {
    ((seed = hash("|", hash(spelled<Axes>(), seed))), ...);
    return seed;
  }
};

template <class Space>
constexpr bool is_refused_space = requires { requires Space::is_refused; };

template <class Space>
inline constexpr space_info space_of = {
    type_name<Space>(),
    type_name<typename Space::domain>(),
    axes_facts<typename Space::axes>::names.data(),
    Space::axes::count,
    Space::size,
    zero_of<Space>.data(),
    hz_of<typename Space::rate>,
    is_refused_space<Space> ? 0
                            : axes_facts<typename Space::axes>::key(hash(spelled<typename Space::domain>())),
    Space::domain::actuated,
    duplicate_axis<Space>,
    is_refused_space<Space> ? -1 : missing_limits<Space>,
    missing_limits<Space> >= 0 && continuous_along<Space>[static_cast<std::size_t>(
                                      missing_limits<Space> < 0 ? 0 : missing_limits<Space>)],
    type_name<typename Space::domain::quantity>(),
    lower_limits<Space, typename Space::domain::quantity>.data(),
    upper_limits<Space, typename Space::domain::quantity>.data(),
    axes_facts<typename Space::axes>::labels.data(),
    unit_of<typename Space::domain::quantity>(),
    coordinates_of<typename Space::domain>(),
    coordinate_units_of<typename Space::domain>(),
    only_of<Space>(),
    only_count_of<Space>(),
};

// The rates must agree only if both spaces state one.
constexpr bool matches(const space_info& a, const space_info& b) {
  if (a.key == 0 || b.key == 0) return true;  // the compiler has refused one
  return a.key == b.key && (a.hz == b.hz || a.hz == 0 || b.hz == 0);
}

}  // namespace cca::detail
