// A vector that the program gives to a compiled world: three numbers, an array of them, or a vector of Eigen.
#pragma once

#include <array>
#include <cstddef>

#include <cca/base/eigen.hpp>
#include <cca/sim/compiled/scalar.hpp>

namespace cca::sim::detail {

template <class Real>
struct given_vector {
  std::array<Real, 3> numbers{};

  given_vector() = default;
  given_vector(const Real& x, const Real& y, const Real& z) : numbers{x, y, z} {}
  given_vector(const std::array<Real, 3>& v) : numbers(v) {}
  template <class Of>
  given_vector(const Eigen::MatrixBase<Of>& v) : numbers{Real(v[0]), Real(v[1]), Real(v[2])} {}
};

template <class Real>
bool is_finite(const Real& x) {
  return everywhere(x - x == Real(0.0));
}
// What is not finite is ignored.
template <class Real>
void take_finite(std::array<Real, 3>& kept, const given_vector<Real>& wanted) {
  for (std::size_t k = 0; k < 3; ++k)
    if (is_finite(wanted.numbers[k])) kept[k] = wanted.numbers[k];
}

}  // namespace cca::sim::detail
