// An axis on a virtual drive that waits to be tuned through its door: `tuning --door`. docs/tuning.md
#include <cca/door.hpp>
#include <cca/main.hpp>

#include "axis.hpp"

struct program : cca::robot_program<tuning::axis> {
  program() { purpose = "an axis on a virtual drive, to be tuned by tests of its reference"; }
};

int main(int count, char** words) { return cca::robot_main<program>(count, words); }
