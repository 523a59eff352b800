#pragma once
// What flows between the components of the trot, besides the robot's own spaces.
#include <cca/space/domain.hpp>

namespace trot {

struct stride : cca::dimension<"stride"> {};  // one turn of the oscillator, a step of each leg
struct yaw : cca::dimension<"yaw"> {};

struct wanted_amplitude : cca::space<cca::amplitude, cca::axes<stride>, cca::rate<100>> {
};  // 1: the full gait; negative: stand
struct gait_amplitude : cca::space<cca::amplitude, cca::axes<stride>, cca::rate<1000>> {};
struct gait_phase : cca::space<cca::phase, cca::axes<stride>, cca::rate<1000>> {};
struct turning : cca::space<cca::number, cca::axes<yaw>, cca::rate<100>> {
};  // > 0 to the left: right legs swing farther

}  // namespace trot
