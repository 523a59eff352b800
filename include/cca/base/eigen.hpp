// Eigen's fixed-size vectors, the only part of Eigen that the core includes (Eigen/Geometry would cost 0.1 s
// per file). inlining.hpp defines the macros that Eigen reads, so it stands first.
#pragma once

#include <cca/base/inlining.hpp>

#include <Eigen/Core>

namespace cca::detail {

using vector3 = Eigen::Matrix<double, 3, 1>;
using vector4 = Eigen::Matrix<double, 4, 1>;

template <class Type> concept EigenVector =
    requires { Type::RowsAtCompileTime; } && requires(const Type& v) { v.derived(); };

}  // namespace cca::detail
