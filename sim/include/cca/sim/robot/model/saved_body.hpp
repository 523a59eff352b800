// The state of one body of the engine, as numbers: position, rotation, velocity and angular velocity.
//
// The engine keeps a rotation both as quaternion and as matrix; both are saved, since computing one from the
// other would change bits. Knows nothing of the engine (body_state.hpp saves and restores it).
#pragma once

#include <array>

namespace cca::sim {

struct body_state {
  std::array<double, 3> position;
  std::array<double, 4> quaternion;
  std::array<double, 12> rotation;  // the engine's 3 x 4 rows
  std::array<double, 3> velocity;
  std::array<double, 3> angular_velocity;
};

}  // namespace cca::sim
