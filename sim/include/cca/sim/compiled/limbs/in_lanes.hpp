// Numbers of several limbs at once: each in a lane of a vector, or of one limb as it is.
#pragma once

#include <cstddef>
#include <type_traits>

#include <cca/base/compiler.hpp>

namespace cca::sim::detail {

template <class Real, std::size_t Width>
using number_of_limbs = std::conditional_t<Width == 1, Real, cca::detail::lanes>;

// f(of[0]), f(of[1]), ... in their lanes.
template <class Real, std::size_t Width, class Limb, class F>
[[gnu::always_inline]] inline number_of_limbs<Real, Width> gathered(const Limb* of, F f) {
  if constexpr (Width == 1) {
    return f(of[0]);
  } else {
    number_of_limbs<Real, Width> x{};
    for (std::size_t l = 0; l < Width; ++l) x[l] = f(of[l]);
    return x;
  }
}
// f(of[0]) = the first lane of x, f(of[1]) = the second one, ...
template <class Real, std::size_t Width, class Limb, class F>
[[gnu::always_inline]] inline void scatter(const Limb* of, const number_of_limbs<Real, Width>& x, F f) {
  if constexpr (Width == 1) f(of[0]) = x;
  else
    for (std::size_t l = 0; l < Width; ++l) f(of[l]) = x[l];
}

}  // namespace cca::sim::detail
