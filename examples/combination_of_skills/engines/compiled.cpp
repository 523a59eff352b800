// `combination_of_skills --engine compiled`: the same program, its robot in compiled physics
// (docs/physics.md).
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "../program.hpp"
#include "compiled.hpp"

namespace {

struct compiled_skills : trot::watched<skills::architecture<cca::sim::compiled_oncilla>> {};

}  // namespace

int skills::compiled_main(int count, char** words) {
  return cca::robot_main<skills::program<compiled_skills, trot::engine::compiled>>(count, words);
}
