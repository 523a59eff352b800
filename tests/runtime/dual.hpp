// A number and its derivative along one direction: the scalar with which tests differentiate the recorded
// algorithms and the compiled world.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <cca/base/math/angles.hpp>

namespace test {

struct dual {
  double value = 0, slope = 0;

  constexpr dual() = default;
  constexpr dual(double v, double d = 0) : value(v), slope(d) {}
  constexpr dual operator-() const { return {-value, -slope}; }
  friend constexpr dual operator+(const dual& a, const dual& b) {
    return {a.value + b.value, a.slope + b.slope};
  }
  friend constexpr dual operator-(const dual& a, const dual& b) {
    return {a.value - b.value, a.slope - b.slope};
  }
  friend constexpr dual operator*(const dual& a, const dual& b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope};
  }
  friend constexpr dual operator/(const dual& a, const dual& b) {
    const double q = a.value / b.value;
    return {q, (a.slope - q * b.slope) / b.value};
  }
  friend constexpr bool operator<(const dual& a, const dual& b) { return a.value < b.value; }
  friend constexpr bool operator>(const dual& a, const dual& b) { return a.value > b.value; }
  friend constexpr bool operator<=(const dual& a, const dual& b) { return a.value <= b.value; }
  friend constexpr bool operator==(const dual& a, const dual& b) { return a.value == b.value; }
  friend constexpr bool is_zero(const dual& x) { return x.value == 0 && x.slope == 0; }
  friend constexpr dual select(bool condition, const dual& yes, const dual& no) {
    return condition ? yes : no;
  }
  friend constexpr double plain(const dual& x) { return x.value; }
  friend dual root(const dual& x) {
    const double r = std::sqrt(x.value);
    return {r, x.slope / (2 * r)};
  }
  friend auto sine_and_cosine(const dual& x) {
    struct {
      dual sine, cosine;
    } both;
    const auto of = cca::math::sine_and_cosine(x.value);
    both.sine = {of.sine, of.cosine * x.slope}, both.cosine = {of.cosine, -of.sine * x.slope};
    return both;
  }
};

// What the recorded algorithms take of the joints of a reduced body at these coordinates: cosines or ways,
// then sines.
template <const auto& Reduced, class Coordinates>
auto joint_values_at(const Coordinates& q) {
  constexpr auto values = static_cast<std::size_t>(Reduced.value_count);
  std::array<dual, 2 * values> all;
  for (std::size_t i = 0; i < values; ++i) {
    const auto& v = Reduced.values[i];
    const dual x = dual(v.ratio) * q[static_cast<std::size_t>(v.coordinate)];
    const auto turn = sine_and_cosine(x);
    all[i] = v.revolute ? turn.cosine : x;
    all[values + i] = v.revolute ? turn.sine : dual();
  }
  return all;
}

}  // namespace test
