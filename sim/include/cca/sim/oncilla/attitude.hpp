// Orientation of the trunk as a quaternion, and as roll, pitch and yaw.
#pragma once

#include <algorithm>
#include <array>

#include <cca/base/math.hpp>

namespace cca::sim {

using vector3 = std::array<double, 3>;

struct quaternion {
  double w = 1, x = 0, y = 0, z = 0;
};

// Roll about x, then pitch about y, then yaw about z, each about an axis of the world (x forward, y left, z
// up). Pitch is positive with the nose down, yaw to the left, roll to the right.
struct roll_pitch_yaw {
  double roll, pitch, yaw;
};

inline roll_pitch_yaw attitude(const quaternion& q) {
  return {math::atan2(2 * (q.w * q.x + q.y * q.z), 1 - 2 * (q.x * q.x + q.y * q.y)),
          math::asin(std::clamp(2 * (q.w * q.y - q.z * q.x), -1.0, 1.0)),
          math::atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))};
}

}  // namespace cca::sim
