// The Oncilla trots in the simulator. `trot --help` lists the options.
//
// To learn from it, read in this order:
//   spaces.hpp               the types of what flows between the components
//   throttle.hpp, stride_oscillator.hpp, gait.hpp, posture.hpp
//                            the components
//   architecture.hpp         how they are wired
//   any_engine.hpp           a run in the simulator
//   trot.toml                the parameters
//   program.hpp              what the program does around a run
// engines/ has the same program with the robot in compiled physics. report/ has what it adds to the main
// function for robots: options, progress bar, figures, CSV and SVG files. The search for gait parameters is
// in tools/gait_search.
#include <cca/sim/oncilla.hpp>

#include "engines/compiled.hpp"
#include "program.hpp"

namespace {

struct simulated_trot : trot::watched<trot::architecture<cca::sim::oncilla>> {};

}  // namespace

int main(int count, char** words) {
  if (trot::engine_in(count, words) == trot::engine::compiled) return trot::compiled_main(count, words);
  return cca::robot_main<trot::program<simulated_trot, trot::engine::ode>>(count, words);
}
