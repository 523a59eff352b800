#pragma once
// Whether a number is within a share of another one; doctest's Approx also takes that share of 1.
#include <cmath>

namespace uncertain_test {

inline bool close_to(double x, double wanted, double share = 1e-9) {
  return std::abs(x - wanted) <= share * std::abs(wanted);
}

}  // namespace uncertain_test
