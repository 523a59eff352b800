#pragma once
// The spaces of the trot: what flows between its components, besides the robot's own spaces.
#include <cca/robots/oncilla/spaces.hpp>
#include <cca/space/domain.hpp>

namespace trot {

namespace oncilla = cca::robots::oncilla;  // axes and spaces of the robot

struct stride : cca::dimension<"stride"> {};  // one turn of the oscillator: one step of each leg
struct yaw : cca::dimension<"yaw"> {};
struct pitch : cca::dimension<"pitch"> {};
struct roll : cca::dimension<"roll"> {};

// 1: the full gait; negative: stand.
struct wanted_amplitude : cca::space<cca::amplitude, cca::axes<stride>, cca::rate<100>> {};
struct gait_amplitude : cca::space<cca::amplitude, cca::axes<stride>, cca::rate<1000>> {};
struct gait_phase : cca::space<cca::phase, cca::axes<stride>, cca::rate<1000>> {};
// Positive: to the left, so the right legs swing farther.
struct turning : cca::space<cca::number, cca::axes<yaw>, cca::rate<100>> {};
// rad. Pitch: added to all hips; positive: the feet forward. Roll: added to the left knees and taken from the
// right ones; positive: the right legs get longer.
struct leaning : cca::space<cca::number, cca::axes<pitch, roll>, cca::rate<100>> {};

}  // namespace trot
