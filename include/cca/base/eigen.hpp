// Eigen's fixed-size vectors, the only part of Eigen that the core includes (Eigen/Geometry would cost 0.1 s
// per file).
//
// EIGEN_DISABLE_UNALIGNED_ARRAY_ASSERT: since C++17 `new` aligns as the type asks, so Eigen's check of an
// array's alignment never fires. Without NDEBUG it makes the constructor of each vector too large for g++ 12
// to inline, and a beat would be full of calls.
//
// EIGEN_STRONG_INLINE: Eigen forces inlining only on MSVC. Without it clang simplifies the parts of an
// expression first and loads a factor and the pointer beside it as one packet; the expression and the port
// then stay in memory.
#pragma once

#include <cca/base/compiler.hpp>

#ifndef EIGEN_DISABLE_UNALIGNED_ARRAY_ASSERT
#define EIGEN_DISABLE_UNALIGNED_ARRAY_ASSERT
#endif

#if defined(__clang__) && !defined(EIGEN_STRONG_INLINE)
#define EIGEN_STRONG_INLINE __attribute__((always_inline)) inline
#endif

#include <Eigen/Core>

namespace cca::detail {

using vector3 = Eigen::Matrix<double, 3, 1>;
using vector4 = Eigen::Matrix<double, 4, 1>;

template <class Type> concept EigenVector =
    requires { Type::RowsAtCompileTime; } && requires(const Type& v) { v.derived(); };

}  // namespace cca::detail
