// The program of a robot in the field, which is recorded and stops by a fault:
//
//   recordings_field --record field.mcap
//
// `recordings_replay field.mcap` makes a test of it. docs/recordings.md
#include <cca/main.hpp>
#include <cca/record.hpp>  // offers --record

#include "leg.hpp"

// [program]
struct program : cca::robot_program<leg_loop<difference>> {
  program() {
    purpose = "a leg that swings, until a guard stops it";
    settings.seconds = 2;
    settings.speed.reset();  // a fast run
  }
};

int main(int count, char** words) { return cca::robot_main<program>(count, words); }
// [program end]
