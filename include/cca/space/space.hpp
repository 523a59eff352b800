// A space is a domain type, its ordered axes and, optionally, its update rate.
//
//   struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};
//
// Two spaces match if domain type (with its frame), ordered axes and rate agree, whatever their names. A rate
// that only one of them states does not count.
#pragma once

#include <array>
#include <concepts>
#include <type_traits>

#include <cca/space/dimension.hpp>
#include <cca/base/eigen.hpp>

namespace cca {

namespace detail {

// A function: after a failed static_assert in a struct, the compiler would not know the struct's members.
template <auto Hz>
consteval double checked_rate() {
  constexpr bool is_positive = Hz > 0;
  static_assert(is_positive,
                "rate.missing: a rate is a number of updates per second above 0, as in `cca::rate<1000>`; "
                "where none is meant, leave it out");
  return is_positive ? static_cast<double>(Hz) : 1;
}

}  // namespace detail

// Updates per second, of a space or of a graph.
template <auto Hz>
struct rate {
  static constexpr double hz = detail::checked_rate<Hz>();
};

template <class... Axes>
struct axes {
  static constexpr int count = sizeof...(Axes);

  template <class Axis>
  static constexpr bool contains = (std::is_same_v<Axis, Axes> || ...);

  template <class Axis>
  static constexpr int index_of = [] {
    int index = 0;
    (void)((std::is_same_v<Axis, Axes> || (++index, false)) || ...);
    return index;
  }();
};

template <class Domain, class Axes, class Rate = void>
struct space {
  using domain = Domain;
  using axes = Axes;
  using rate = Rate;
  static constexpr int size = Domain::width(Axes::count);  // stored coordinates; an orientation has four
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

// The coordinates of the space's zero: an input holds it until its first sample arrives.
template <class Space>
constexpr auto zero_of = [] {
  std::array<double, static_cast<std::size_t>(Space::size)> zero{};
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
