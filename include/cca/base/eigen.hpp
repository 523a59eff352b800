// Eigen's fixed-size vectors, the only part of Eigen that the core includes (Eigen/Geometry would cost 0.1 s
// a file).
//
// Since C++17 `new` aligns as a type asks, so Eigen's check that an array is aligned never fires. Without
// NDEBUG it makes the constructor of each vector too heavy for g++ 12 to inline: a beat would be full of
// calls.
//
// What Eigen wants inlined in any case it says to MSVC alone. Clang would simplify the pieces of an
// expression first, and there read a factor and the pointer beside it as one packet; then neither expression
// nor port ever leaves memory.
#pragma once

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
