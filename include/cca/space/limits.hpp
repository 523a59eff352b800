// The limits of a space's axes, as arrays in the order of the axes; infinite where an axis states none.
//
// The angle of a continuous axis has no limits; a command of it is kept within the limits of its velocity
// instead, so these must be there. Errors: space.bad_limits; the message of a limit that is missing is
// space.missing_limits.
// Cost: constants. For an axis without limits the compiler drops both comparisons.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/space/dimension.hpp>

namespace cca::detail {

template <class Axis, class Quantity>
constexpr double lower_limit_of = [] {
  if constexpr (axis_has_limits<Axis, Quantity>) return Axis::limits.template of<Quantity>().lower;
  else return -std::numeric_limits<double>::infinity();
}();

template <class Axis, class Quantity>
constexpr double upper_limit_of = [] {
  if constexpr (axis_has_limits<Axis, Quantity>) return Axis::limits.template of<Quantity>().upper;
  else return std::numeric_limits<double>::infinity();
}();

// The quantity whose limits a command along this axis needs.
template <class Axis, class Quantity>
using needed_limits =
    std::conditional_t<is_continuous<Axis> && std::is_same_v<Quantity, angle>, velocity, Quantity>;

template <class Quantity, class... Axes>
struct swapped_limits {
  static constexpr void tell(text& m) {
    const char* between = "space.bad_limits: the lower limit of ";
    ((void)(lower_limit_of<Axes, Quantity> <= upper_limit_of<Axes, Quantity> ||
            (m << between << type_name<Quantity>() << " of the axis " << Axes::name, between = " and of ",
             true)),
     ...);
    m << " is above its upper limit, or one of both is NaN: write the lower one first, as in "
         "cca::angle{-0.5, 0.5}";
  }
};
template <class... Axes>
struct limits_of_circle {
  static constexpr void tell(text& m) {
    const char* between = "space.bad_limits: the axis ";
    ((void)(!(is_continuous<Axes> && axis_has_limits<Axes, angle>) ||
            (m << between << Axes::name, between = " and ", true)),
     ...);
    m << " is continuous and states limits of angle, which a joint that turns without end lacks: leave out "
         "these, or `continuous`";
  }
};

template <class Axes, class Quantity>
struct limits_along;

template <template <class...> class List, class... Axes, class Quantity>
struct limits_along<List<Axes...>, Quantity> {
  static constexpr std::array<double, sizeof...(Axes)> lower{lower_limit_of<Axes, Quantity>...};
  static constexpr std::array<double, sizeof...(Axes)> upper{upper_limit_of<Axes, Quantity>...};

  static_assert(holds_or_tells<((lower_limit_of<Axes, Quantity> <= upper_limit_of<Axes, Quantity>) && ...),
                               swapped_limits<Quantity, Axes...>>::value);
  static_assert(holds_or_tells<!((is_continuous<Axes> && axis_has_limits<Axes, angle>) || ...),
                               limits_of_circle<Axes...>>::value);

  static constexpr int first_missing() {
    const std::array<bool, sizeof...(Axes)> stated{
        (axis_has_limits<Axes, needed_limits<Axes, Quantity>> || has_refused_limits<Axes>)...};
    for (std::size_t i = 0; i < sizeof...(Axes); ++i)
      if (!stated[i]) return static_cast<int>(i);
    return -1;
  }
  // Whether the axis of this index is continuous, and this is about its angle.
  static constexpr std::array<bool, sizeof...(Axes)> continuous{
      (is_continuous<Axes> && std::is_same_v<Quantity, angle>)...};
  static constexpr bool any_continuous =
      (false || ... || is_continuous<Axes>) && std::is_same_v<Quantity, angle>;
};

// One number per axis.
template <class Space, class Quantity>
constexpr const auto& lower_limits = limits_along<typename Space::axes, Quantity>::lower;
template <class Space, class Quantity>
constexpr const auto& upper_limits = limits_along<typename Space::axes, Quantity>::upper;

// Index of the first axis without limits for the domain type's quantity, or -1.
template <class Space>
constexpr int missing_limits =
    limits_along<typename Space::axes, typename Space::domain::quantity>::first_missing();

// Whether the angle of an axis has no end, per axis; false for other quantities.
template <class Space>
constexpr const auto& continuous_along =
    limits_along<typename Space::axes, typename Space::domain::quantity>::continuous;
template <class Space>
constexpr bool has_continuous_angles =
    limits_along<typename Space::axes, typename Space::domain::quantity>::any_continuous;

template <class Axes>
struct repeated_in;

template <template <class...> class List, class... Axes>
struct repeated_in<List<Axes...>> {
  static constexpr int first() {
    const std::array<int, sizeof...(Axes)> found{List<Axes...>::template index_of<Axes>...};
    for (std::size_t i = 0; i < sizeof...(Axes); ++i)
      if (found[i] != static_cast<int>(i)) return static_cast<int>(i);
    return -1;
  }
};

// Index of the first axis that a space lists again, or -1.
template <class Space>
constexpr int duplicate_axis = repeated_in<typename Space::axes>::first();

}  // namespace cca::detail
