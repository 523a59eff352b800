// Numbers of a device in its own format, on the way from the node that talks to the device to the nodes of
// its parts: `Numbers` per axis, without a quantity, limits or methods. Derive a domain type of your own from
// it, so that the records of two devices do not match.
#pragma once

#include <cca/base/compiler.hpp>

namespace cca {

template <int Numbers>
struct record {
  using quantity = void;
  static constexpr bool actuated = false;
  static constexpr int width(int axes) { return Numbers * axes; }
  static constexpr double zero(int, int) { return 0; }
  template <class Self>
  struct methods {};
};

}  // namespace cca
