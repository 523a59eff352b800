// The mass matrix of a body, computed once in a beat for all components that derive it from the same angles
// (derived_of_body.hpp).
//
//   cca::derived<cca::mass_of<Body>, "angles"> mass     `.matrix`, and its decomposition `.solver`
//
// NaN: as mass_matrix.hpp says; nothing is kept. Precondition of `.solver`: each coordinate moves mass.
// Cost: that of mass_matrix.hpp and positive_matrix.hpp, once. Example:
// tests/runtime/body/derived_of_body.cpp; docs/body.md.
#pragma once

#include <cca/robot/derived_of_body.hpp>
#include <cca/robot/dynamics/mass_matrix.hpp>
#include <cca/base/math/positive_matrix.hpp>

namespace cca {

template <int Size>
struct decomposed_mass {
  Eigen::Matrix<double, Size, Size> matrix;
  detail::positive_matrix<Size> solver;
};

template <class Type>
struct mass_of {
  static constexpr int size = body_pose<Type>::size;
  using value = decomposed_mass<size>;
  using from = cca::from<pose_of<Type>>;
  static value of(const body_pose<Type>& now) {
    const Eigen::Matrix<double, size, size> m = mass_matrix(now);
    return {m, detail::positive_matrix<size>(m)};
  }
};

}  // namespace cca
