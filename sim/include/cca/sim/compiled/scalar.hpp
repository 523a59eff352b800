// What a compiled world asks of its scalar beside + - * /: choices without a branch.
//
// A scalar of your own (a dual number) brings these by argument-dependent look-up, besides comparisons
// and `sine_and_cosine`: `select(condition, yes, no)`; `everywhere(condition)`, whether it holds in all
// lanes; `root(x)`.
#pragma once

#include <array>
#include <type_traits>

#include <cca/base/math/angles.hpp>
#include <cca/base/math/roots.hpp>

namespace cca::sim::detail {

// Whether a scalar is a number for each of several worlds (lanes/lanes.hpp).
template <class Real>
inline constexpr bool is_in_lanes = false;

// What is a number of a world whatever its scalar is: in lanes each has its own.
template <class Real>
using number_of = std::conditional_t<is_in_lanes<Real>, Real, double>;

constexpr double select(bool condition, double yes, double no) { return condition ? yes : no; }
constexpr bool everywhere(bool condition) { return condition; }
constexpr double root(double x) { return cca::math::sqrt(x); }

// Whether a vector is zero and adds nothing: no for a scalar that has more than its value.
template <class Real>
constexpr bool is_none(const std::array<Real, 3>& v) {
  if constexpr (std::is_same_v<Real, double>) return v[0] == 0 && v[1] == 0 && v[2] == 0;
  else if constexpr (is_in_lanes<Real>)
    return everywhere((v[0] == Real(0.0)) & (v[1] == Real(0.0)) & (v[2] == Real(0.0)));
  else return false;
}

// Whether a number that is 0 or more is above 0; in lanes, in one of them.
constexpr bool is_any(double x) { return x > 0; }
template <class Number>
  requires is_in_lanes<Number>
constexpr bool is_any(const Number& x) {
  return !everywhere(!(x > Number(0.0)));
}

template <class Real>
constexpr Real smaller(const Real& a, const Real& b) {
  return select(a < b, a, b);
}
template <class Real>
constexpr Real larger(const Real& a, const Real& b) {
  return select(a < b, b, a);
}
template <class Real>
constexpr Real between(const Real& low, const Real& x, const Real& high) {
  return larger(low, smaller(x, high));
}

}  // namespace cca::sim::detail
