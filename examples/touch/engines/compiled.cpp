// `touch --engine compiled`: the same program, its arm in compiled physics (docs/physics.md).
#include <cca/sim/compiled/robot.hpp>

#include "../program.hpp"
#include "compiled.hpp"

namespace {

struct compiled_touch
    : touch::observable<touch::architecture<cca::sim::robot<touch::arm::description, cca::sim::compiled>>> {};

}  // namespace

int touch::compiled_main(int count, char** words) { return touch::main_of<compiled_touch>(count, words); }
