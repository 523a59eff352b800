// Checks of input samples. NaN in a state never leaves it again, so the components of this folder ignore
// samples that are not finite.
//
//   detail::all_finite(v)     no coordinate is NaN or infinite; costs a sum and a comparison
//   detail::has_come(port)    a sample has arrived (no initial value) and it is finite
#pragma once

#include <cca/space/sample.hpp>

namespace cca::detail {

template <class Vector>
inline bool all_finite(const Eigen::MatrixBase<Vector>& v) {
  return (v - v).sum() == 0;
}

template <class Port>
inline bool has_come(const Port& port) {
  return port.origin() != never && all_finite(port.vector());
}

}  // namespace cca::detail
