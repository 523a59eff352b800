// A number and its derivative along one direction, for the scalar of the recorded algorithms.
#pragma once

#include <cmath>

namespace body_test {

struct dual {
  double value = 0, slope = 0;

  constexpr dual() = default;
  constexpr dual(double v, double d = 0) : value(v), slope(d) {}
  constexpr dual operator-() const { return {-value, -slope}; }
};
constexpr dual operator+(const dual& a, const dual& b) { return {a.value + b.value, a.slope + b.slope}; }
constexpr dual operator-(const dual& a, const dual& b) { return {a.value - b.value, a.slope - b.slope}; }
constexpr dual operator*(const dual& a, const dual& b) {
  return {a.value * b.value, a.slope * b.value + a.value * b.slope};
}
constexpr dual operator/(const dual& a, const dual& b) {
  const double q = a.value / b.value;
  return {q, (a.slope - q * b.slope) / b.value};
}
constexpr bool is_zero(const dual& x) { return x.value == 0 && x.slope == 0; }
inline dual cosine(const dual& x) { return {std::cos(x.value), -std::sin(x.value) * x.slope}; }
inline dual sine(const dual& x) { return {std::sin(x.value), std::cos(x.value) * x.slope}; }

}  // namespace body_test
