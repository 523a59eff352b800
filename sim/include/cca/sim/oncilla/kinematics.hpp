// The leg in its own plane, in closed form: forward and inverse kinematics, and the stretch of the spring.
//
// Plane: x forward, z up, origin in the hip. A segment at angle t points to (sin t, -cos t). The upper
// segment stands at `hip`, the middle one at `hip - knee`, the lower one parallel to the upper (the
// pantograph). So with the toe straight the leg is a chain of two links: upper + lower + toe, and middle.
#pragma once

#include <algorithm>
#include <cmath>

#include <cca/base/math.hpp>
#include <cca/sim/oncilla/oncilla_model.hpp>

namespace cca::sim {

struct leg_angles_in_plane {
  double hip, knee;
};

struct foot_in_plane {
  double x, z;
};

inline foot_in_plane foot_position(const oncilla_model& m, leg_angles_in_plane q) {
  const double along_upper = m.upper_length + m.foot_lever();
  const double middle_angle = q.hip - q.knee;
  const auto upper = math::sine_and_cosine(q.hip), middle = math::sine_and_cosine(middle_angle);
  return {along_upper * upper.sine + m.middle_length * middle.sine,
          -along_upper * upper.cosine - m.middle_length * middle.cosine};
}

// The angles that bring the foot to a point, or, if it is out of reach, towards it. The knee stays inside its
// range.
inline leg_angles_in_plane leg_angles_for(const oncilla_model& m, foot_in_plane foot) {
  const double a = m.upper_length + m.foot_lever(), b = m.middle_length;
  const double cosine = (foot.x * foot.x + foot.z * foot.z - a * a - b * b) / (2 * a * b);
  const double knee = m.knee_range.clamp(math::acos(std::clamp(cosine, -1.0, 1.0)));
  const double towards_foot = math::atan2(foot.x, -foot.z);
  const auto bent = math::sine_and_cosine(knee);
  return {towards_foot + math::atan2(b * bent.sine, a + b * bent.cosine), knee};
}

// Length of the diagonal, from the knee to the spring's end on the lower segment (law of cosines).
inline double diagonal_length(const oncilla_model& m, double knee) {
  return math::sqrt(m.middle_length * m.middle_length + m.spring_arm * m.spring_arm -
                    2 * m.middle_length * m.spring_arm * math::cos(knee));
}

inline double diagonal_stretch(const oncilla_model& m, double knee) {
  return std::max(0.0, diagonal_length(m, knee) - diagonal_length(m, m.spring_reference) + m.spring_preload);
}

}  // namespace cca::sim
