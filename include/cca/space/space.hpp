// A space is a domain type, its ordered axes and, optionally, its update rate.
//
//   struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};
//
// Two spaces match if domain type (with its frame), ordered axes and rate agree, whatever their names. A rate
// that only one of them states does not count.
// Errors: space.bad_axes, space.bad_domain, space.bad_limits, rate.missing.
#pragma once

#include <array>
#include <concepts>
#include <initializer_list>
#include <type_traits>
#include <utility>

#include <cca/space/dimension.hpp>
#include <cca/base/eigen.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/space/messages/space_in_words.hpp>

namespace cca {

namespace detail {

template <auto Hz>
struct rate_not_positive {
  static constexpr void tell(text& m) {
    m << "rate.missing: `cca::rate<" << static_cast<double>(Hz)
      << ">` is no rate, which is a number of updates per second above 0, as `cca::rate<1000>`; where none "
         "is meant, leave it out";
  }
};

template <auto Hz>
consteval double checked_rate() {
  constexpr bool is_positive = Hz > 0;
  static_assert(holds_or_tells<is_positive, rate_not_positive<Hz>>::value);
  return is_positive ? static_cast<double>(Hz) : 1;
}

}  // namespace detail

// Updates per second, of a space or of a graph.
template <auto Hz>
struct rate {
  static constexpr double hz = detail::checked_rate<Hz>();
};

namespace detail {

constexpr bool hold(std::initializer_list<bool> all) {
  for (const bool one : all)
    if (!one) return false;
  return true;
}

}  // namespace detail

template <class... Axes>
struct axes {
  static constexpr int count = sizeof...(Axes);
  static_assert(detail::hold(
      {detail::holds_or_tells<detail::lists_limits<Axes>, detail::no_limits_of_axis<Axes>>::value...}));

  template <class Axis>
  static constexpr bool contains = (std::is_same_v<Axis, Axes> || ...);

  template <class Axis>
  static constexpr int index_of = [] {
    int index = 0;
    (void)((std::is_same_v<Axis, Axes> || (++index, false)) || ...);
    return index;
  }();
};

namespace detail {

template <class Type>
constexpr bool is_axes = false;
template <class... Axes>
constexpr bool is_axes<axes<Axes...>> = true;

// Stands for what is no domain type, so that there is one error and not twenty.
struct no_domain {
  using quantity = void;
  static constexpr bool actuated = false;
  static constexpr int width(int axes) { return axes; }
  static constexpr double zero(int, int) { return 0; }
  template <class>
  struct methods {};
};

template <class Axes, class Domain>
struct no_axes {
  static constexpr void tell(text& m) {
    m << "space.bad_axes: the second argument of a space is the list of its axes, and that of a cca::space<"
      << type_name<Domain>();
    if constexpr (std::is_void_v<Axes>) m << "> is missing";
    else m << ", ...> is `" << type_name<Axes>() << "`";
    m << ": write them as in `struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};`";
  }
};
template <class Domain>
struct no_domain_type {
  static constexpr void tell(text& m) {
    m << "space.bad_domain: the first argument of a space is a domain type, as cca::joint_angles, and `"
      << type_name<Domain>()
      << "` is none; a type of your own is one if it states `quantity`, `actuated`, `width`, `zero` and "
         "`methods`: see CONTRIBUTING.md, `How to add a domain type`";
  }
};
template <class Domain>
struct domain_without_quantity {
  static constexpr void tell(text& m) {
    m << "space.bad_domain: the domain type " << type_name<Domain>()
      << " does not say what is measured along its axes: add `using quantity = cca::angle;` or another "
         "quantity to it, or `using quantity = void;` for none";
  }
};

template <class Axes, class Domain>
struct axes_of_other_count {
  static constexpr void tell(text& m) {
    m << "space.bad_axes: a space of " << type_name<Domain>() << " has " << Domain::axis_count
      << " axes, as cca::axes<cca::x, cca::y, cca::z>, and this one has " << Axes::count;
    if constexpr (Axes::count > 0) m << " (" << axes_in_words<Axes>() << ")";
    m << ": its numbers are those of a whole, and none can be left out or added";
  }
};
template <class Rate>
struct no_rate {
  static constexpr void tell(text& m) {
    m << "rate.missing: the third argument of a space is its rate, as `cca::rate<1000>`, and `"
      << type_name<Rate>() << "` is none; where none is meant, leave it out";
  }
};
template <auto Hz>
struct no_rate<rate<Hz>> : rate_not_positive<Hz> {};

template <class Domain>
constexpr bool is_domain = requires {
  { Domain::width(1) } -> std::convertible_to<int>;
  { Domain::zero(0, 1) } -> std::convertible_to<double>;
  { Domain::actuated } -> std::convertible_to<bool>;
};
template <class Axes, class Domain>
constexpr bool has_its_axes = is_axes<Axes>;
template <class Axes, class Domain>
  requires is_axes<Axes> && requires { Domain::axis_count; }
constexpr bool has_its_axes<Axes, Domain> = Axes::count == Domain::axis_count;

// Each of these functions gives a type in place of one that it refuses, so that there is one error and not
// twenty.

template <class Domain>
constexpr auto domain_or_refused() {
  constexpr bool has_quantity = requires { typename Domain::quantity; };
  static_assert(holds_or_tells<is_domain<Domain>, no_domain_type<Domain>>::value);
  static_assert(holds_or_tells<(!is_domain<Domain> || has_quantity), domain_without_quantity<Domain>>::value);
  return std::type_identity<std::conditional_t<is_domain<Domain> && has_quantity, Domain, no_domain>>{};
}

template <class Axes, class Domain>
constexpr auto axes_or_refused() {
  if constexpr (!is_domain<Domain>) {
    return std::type_identity<axes<x>>{};
  } else if constexpr (!has_its_axes<Axes, Domain>) {
    static_assert(holds_or_tells<is_axes<Axes>, no_axes<Axes, Domain>>::value);
    static_assert(holds_or_tells<!is_axes<Axes>, axes_of_other_count<Axes, Domain>>::value);
    using in_place = std::conditional_t<has_its_axes<axes<x, y, z>, Domain> && !has_its_axes<axes<x>, Domain>,
                                        axes<x, y, z>, axes<x>>;
    return std::type_identity<in_place>{};
  } else {
    return std::type_identity<Axes>{};
  }
}

template <class Rate>
constexpr bool is_rate = false;
template <>
inline constexpr bool is_rate<void> = true;  // none is stated
template <auto Hz>
constexpr bool is_rate<rate<Hz>> = Hz > 0;

template <class Rate>
constexpr auto rate_or_refused() {
  static_assert(holds_or_tells<is_rate<Rate>, no_rate<Rate>>::value);
  return std::type_identity<std::conditional_t<is_rate<Rate>, Rate, void>>{};
}

}  // namespace detail

// `Axes` has a default only so that its absence gives a sentence.
template <class Domain, class Axes = void, class Rate = void>
struct space {
  using domain = typename decltype(detail::domain_or_refused<Domain>())::type;
  using axes = typename decltype(detail::axes_or_refused<Axes, Domain>())::type;
  using rate = typename decltype(detail::rate_or_refused<Rate>())::type;
  static constexpr bool is_refused =
      !(std::is_same_v<domain, Domain> && std::is_same_v<axes, Axes> && std::is_same_v<rate, Rate>);
  static_assert(sizeof(axes) != 0);                        // a mistake in an axis is reported from here
  static constexpr int size = domain::width(axes::count);  // stored coordinates; an orientation has four
  using vector_type = Eigen::Matrix<double, size, 1>;
};

template <class Type> concept Space = requires {
  typename Type::domain;
  typename Type::axes;
  typename Type::rate;
  typename Type::vector_type;
  { Type::size } -> std::convertible_to<int>;
};

// The part of a space along some of its axes.
template <class Whole, class... Axes>
struct sub_space : space<typename Whole::domain, axes<Axes...>, typename Whole::rate> {};

// The same axes and rate with another domain type: the result of an operation on a sample of the first.
template <class Whole, class Domain>
struct with_domain : space<Domain, typename Whole::axes, typename Whole::rate> {};

namespace detail {

// Some coordinates of the space's zero. In blocks: the steps of a constant are limited (docs/compilers.md),
// and an image has many coordinates.
template <class Space, int First, int End>
inline constexpr bool has_zeros_in = [] {
  for (int i = First; i < End; ++i)
    if (Space::domain::zero(i, Space::axes::count) != 0) return false;
  return true;
}();
// The space's zero is a vector of zeros; of an orientation it is not.
template <class Space>
inline constexpr bool has_zeros = [] {
  constexpr int block = 16'384;
  return []<int... B>(std::integer_sequence<int, B...>) {
    return (has_zeros_in < Space, B * block, B + 1 == sizeof...(B) ? Space::size : (B + 1) * block > &&...);
  }(std::make_integer_sequence<int, (Space::size + block - 1) / block>{});
}();

// The coordinates of the space's zero: an input holds it until its first sample arrives. Inline, because
// inline data points to it (docs/compilers.md).
template <class Space>
inline constexpr auto zero_of = [] {
  std::array<double, static_cast<std::size_t>(Space::size)> zero{};
  if constexpr (!has_zeros<Space>)
    for (int i = 0; i < Space::size; ++i)
      zero[static_cast<std::size_t>(i)] = Space::domain::zero(i, Space::axes::count);
  return zero;
}();

template <class Rate>
constexpr double hz_of = 0;
template <auto Hz>
constexpr double hz_of<rate<Hz>> = rate<Hz>::hz;

}  // namespace detail
}  // namespace cca
