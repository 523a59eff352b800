// What the target cca::sim compiles once for a project: cca/base/separate/compiled.hpp.
#include <cca/sim/robot/world/robot_world_functions.hpp>
