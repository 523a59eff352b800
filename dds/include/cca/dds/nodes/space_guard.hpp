// What a sample of a foreign program must be before a graph sees it: a quaternion has unit length (to 0.001;
// it is normalised if that is more than rounding), a status is a whole number. Finite numbers are demanded of
// every space elsewhere. Limits are a limiter's matter: a sensor may see more than an actuator may do.
#pragma once

#include <cmath>

#include <cca/base/math/roots.hpp>
#include <cca/space/array.hpp>
#include <cca/space/methods/scalar.hpp>
#include <cca/space/orientation.hpp>
#include <cca/space/pose.hpp>

namespace cca::dds::detail {

// Null, or why it is refused. `q`: x, y, z, w.
inline const char* refuse_quaternion(double* q) {
  const double length = math::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(std::abs(length - 1) < 0.001)) return "an orientation that is no unit quaternion";
  if (std::abs(length - 1) > 1e-12)
    for (int i = 0; i < 4; ++i) q[i] /= length;
  return nullptr;
}

template <class Domain>
struct space_guard {
  static const char* refuse(double*, int) { return nullptr; }
};
template <class Frame>
struct space_guard<orientation<Frame>> {
  static const char* refuse(double* sample, int) { return refuse_quaternion(sample); }
};
template <class Frame>
struct space_guard<pose<Frame>> {
  static const char* refuse(double* sample, int) { return refuse_quaternion(sample + 3); }
};
template <>
struct space_guard<cca::status> {
  static const char* refuse(const double* sample, int axes) {
    for (int i = 0; i < axes; ++i)
      if (!(math::floor(sample[i]) == sample[i])) return "a status that is no whole number";
    return nullptr;
  }
};
template <class Domain, int Count>
struct space_guard<array_domain<Domain, Count>> {
  static const char* refuse(double* sample, int axes) {
    const char* why = nullptr;
    for (int i = 0; i < Count && !why; ++i, sample += Domain::width(axes / Count))
      why = space_guard<Domain>::refuse(sample, axes / Count);
    return why;
  }
};

}  // namespace cca::dds::detail
