// `trot --engine compiled`: the same program, its robot in compiled physics (docs/physics.md).
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "../program.hpp"
#include "compiled.hpp"

namespace {

struct compiled_trot : trot::watched<trot::architecture<cca::sim::compiled_oncilla>> {};

}  // namespace

int trot::compiled_main(int count, char** words) {
  return cca::robot_main<trot::program<compiled_trot, trot::engine::compiled>>(count, words);
}
