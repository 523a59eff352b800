// The robot's components come with one header, which compiles alone.
#include <cca/robot.hpp>

namespace all_of_robot {

using cca::body;
using cca::gravity_compensation;
using cca::inverse_dynamics;
using cca::limiter;
using cca::watchdog;

}  // namespace all_of_robot
