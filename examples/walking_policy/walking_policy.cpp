// A simulated Oncilla walks by a learned policy. `walking_policy --help` lists the options;
// walking_policy_learn makes the weights, walking_policy_seeds judges them.
// engines/ has the same program with the robot in compiled physics.
#include <cca/sim/oncilla.hpp>

#include "engines/compiled.hpp"
#include "program.hpp"

namespace {

struct simulated_walk : trot::watched<walking::architecture<cca::sim::oncilla>> {};

}  // namespace

int main(int count, char** words) {
  if (trot::engine_in(count, words) == trot::engine::compiled) return walking::compiled_main(count, words);
  return cca::robot_main<walking::program<simulated_walk, trot::engine::ode>>(count, words);
}
