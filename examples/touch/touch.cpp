// A compliant arm is shown a movement by hand and repeats it, finds a table by touch and wipes it, and yields
// when somebody pushes it: with many seeds, on all cores, in the simulator.
//
//   touch --count 20 --summary summary.json
//
// program.hpp says what it does around the runs; engines/ has the same program with the arm in compiled
// physics.
#include "engines/compiled.hpp"
#include "program.hpp"

namespace {

struct simulated_touch : touch::observable<touch::simulated> {};

}  // namespace

int main(int count, char** words) {
  if (trot::engine_in(count, words) == trot::engine::compiled) return touch::compiled_main(count, words);
  return touch::main_of<simulated_touch>(count, words);
}
