// The elementary functions of a float: computed in double and rounded once more, so correct in nearly all
// cases and the same bits everywhere.
#pragma once

#include <concepts>

#include <cca/base/math/angles.hpp>
#include <cca/base/math/arcs.hpp>
#include <cca/base/math/exponentials.hpp>
#include <cca/base/math/logarithms.hpp>
#include <cca/base/math/roots.hpp>

namespace cca::math {

#define CCA_OF_FLOAT(function)                  \
  template <std::same_as<float> T>              \
  CCA_INLINE constexpr T function(T x) {        \
    return static_cast<T>(function(double{x})); \
  }
#define CCA_OF_FLOATS(function)                            \
  template <std::same_as<float> T>                         \
  CCA_INLINE constexpr T function(T x, T y) {              \
    return static_cast<T>(function(double{x}, double{y})); \
  }
CCA_OF_FLOAT(sin)
CCA_OF_FLOAT(cos)
CCA_OF_FLOAT(tan)
CCA_OF_FLOAT(exp)
CCA_OF_FLOAT(expm1)
CCA_OF_FLOAT(sinh)
CCA_OF_FLOAT(cosh)
CCA_OF_FLOAT(tanh)
CCA_OF_FLOAT(log)
CCA_OF_FLOAT(atan)
CCA_OF_FLOAT(asin)
CCA_OF_FLOAT(acos)
CCA_OF_FLOAT(sqrt)
CCA_OF_FLOAT(cbrt)
CCA_OF_FLOAT(trunc)
CCA_OF_FLOAT(floor)
CCA_OF_FLOAT(ceil)
CCA_OF_FLOAT(round)
CCA_OF_FLOATS(pow)
CCA_OF_FLOATS(atan2)
CCA_OF_FLOATS(hypot)
CCA_OF_FLOATS(fmod)
#undef CCA_OF_FLOAT
#undef CCA_OF_FLOATS

}  // namespace cca::math
