// `walking_policy --engine compiled`: the same program, its robot in compiled physics (docs/physics.md).
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "../program.hpp"
#include "compiled.hpp"

namespace {

struct compiled_walk : trot::watched<walking::architecture<cca::sim::compiled_oncilla>> {};

}  // namespace

int walking::compiled_main(int count, char** words) {
  return cca::robot_main<walking::program<compiled_walk, trot::engine::compiled>>(count, words);
}
