// What the domain types with one real coordinate an axis share.
#pragma once

#include <cca/space/quantity.hpp>

namespace cca::detail {

struct linear_domain {
  using quantity = value;
  static constexpr bool actuated = false;
  static constexpr int width(int axes) { return axes; }
  static constexpr double zero(int, int) { return 0; }

  template <class Self>
  struct methods {};
};

}  // namespace cca::detail
