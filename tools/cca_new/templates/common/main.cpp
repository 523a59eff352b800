// The program: the robot in the simulator. `my_robot --help` lists its options.
#include <cca/cca.hpp>
#include <cca/door.hpp>  // offers --door
#include <cca/main.hpp>
#include <cca/record.hpp>                // offers --record and --page
#include <cca/record/replay_option.hpp>  // offers --replay

#include "simulation.hpp"

namespace {

struct observed : my_robot::simulated, my_robot::shown, cca::recordable, cca::traceable {};

struct program : cca::robot_program<observed> {
  program() {
    purpose = "my_robot in the simulator";
    settings.seconds = 10;
  }
  void loaded(controller_type& c) override { my_robot::put_down(c); }
  int finish(controller_type& c) override {
    if (!settings.quiet) my_robot::report(c);
    return 0;
  }
};

}  // namespace

int main(int count, char** words) { return cca::robot_main<program>(count, words); }
