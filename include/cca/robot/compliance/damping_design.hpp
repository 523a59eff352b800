// Damping from a damping ratio: the matrix D that gives each mode of a stiffness before an inertia the same
// ratio.
//
//   damping_for(mobility, root, ratio)    mobility: the inverse of the inertia, symmetric and positive
//                                         semidefinite; root: any G with stiffness K = G G^T
//
// For x'' + mobility (D x' + K x) = 0 at the current position: with T = G^T mobility G = V diag(w^2) V^T,
//
//   D = 2 ratio G V diag(1 / w) V^T G^T
//
// each mode has s^2 + 2 ratio w s + w^2 = 0. It is the double diagonalisation with the mobility in the place
// of the inertia, so that a direction in which the body can't move (a stretched arm) needs no exception:
// there D is large, and nothing moves. A w below 1e-6 of the largest counts as that.
//
// NaN and infinity make results that are not finite; nothing is kept.
// Source: Albu-Schaeffer, Ott, Frese, Hirzinger, Cartesian Impedance Control of Redundant Robots: Recent
// Results with the DLR-Light-Weight-Arms, ICRA 2003 (double diagonalisation). Cost: symmetric_eigen.hpp.
#pragma once

#include <algorithm>
#include <cmath>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math/roots.hpp>
#include <cca/robot/compliance/symmetric_eigen.hpp>

namespace cca::detail {

template <int Size>
Eigen::Matrix<double, Size, Size> damping_for(const Eigen::Matrix<double, Size, Size>& mobility,
                                              const Eigen::Matrix<double, Size, Size>& root,
                                              double ratio) {
  using matrix = Eigen::Matrix<double, Size, Size>;
  const symmetric_eigen<Size> modes(math::product(math::product(root.transpose(), mobility), root));
  const double most = modes.values.maxCoeff();
  if (!(most > 1e-200)) return matrix::Zero();  // below, the floor of w would be 0
  const matrix gv = math::product(root, modes.vectors);
  matrix d = matrix::Zero();
  for (int i = 0; i < Size; ++i)
    d +=
        (2 * ratio / math::sqrt(std::max(modes.values[i], 1e-12 * most))) * gv.col(i) * gv.col(i).transpose();
  return d;
}

}  // namespace cca::detail
