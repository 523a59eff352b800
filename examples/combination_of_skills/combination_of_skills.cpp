// The Oncilla trots, stops, reaches for a ball with a front paw, and trots on. Writes a table, a CSV file and
// a picture; --help lists the options.
// engines/ has the same program with the robot in compiled physics.
#include <cca/sim/oncilla.hpp>

#include "engines/compiled.hpp"
#include "program.hpp"

namespace {

struct simulated : trot::watched<skills::architecture<cca::sim::oncilla>> {};

}  // namespace

int main(int count, char** words) {
  if (trot::engine_in(count, words) == trot::engine::compiled) return skills::compiled_main(count, words);
  return cca::robot_main<skills::program<simulated, trot::engine::ode>>(count, words);
}
