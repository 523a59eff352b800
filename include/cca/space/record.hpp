// Numbers of a device in its own form, from the node that alone knows the device to those of its parts: so
// many an axis, without a quantity, limits or methods. A domain type of its own derives from it, so that
// records of two devices do not match.
#pragma once

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
