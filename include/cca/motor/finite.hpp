// What a movement may be made of. A state that NaN has come into is lost for good, so no component of this
// folder takes one in: a sample that is not finite is as good as none, in whatever state it would go.
//
//   detail::all_finite(v)     neither NaN nor infinity among the coordinates: a sum and a comparison
//   detail::has_come(port)    a movement can begin there: a sample has arrived, no initial value, and it is
//   finite
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
