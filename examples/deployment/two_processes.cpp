// Two environments in two processes, over shared memory. In one terminal
//
//   deployment_two_processes --only robot --shared-memory /leg
//
// and in another the same with `--only mind`; without both options they are two threads of one process. The
// robot's process compares the leg with that of one loop, bit for bit. Kill one of them, and the other stops
// with a fault; a signal ends both in order. Pages: docs/environments.md, docs/programs.md.
#include <vector>

#include <cca/main.hpp>

#if __has_include(<cca/record.hpp>)
#include <cca/record.hpp>                // offers --record
#include <cca/record/replay_option.hpp>  // offers --replay
#endif
#if __has_include(<cca/door.hpp>)
#include <cca/door.hpp>  // offers --door
#endif

#include "one_loop.hpp"

namespace {

// [program]
struct program : cca::robot_program<split> {
  program() {
    purpose = "a leg and its thoughts, in two threads or two processes";
    settings.seconds = 0.3;
    settings.speed.reset();  // a fast run
  }

  bool between(controller_type& c) override {
    if (runs("robot")) angles.push_back(c.get<"leg">().angle);
    return true;
  }

  int finish(controller_type& c) override { return runs("robot") ? compare_with_one_loop(angles, c) : 0; }

  // [program end]
  // [main]
  std::vector<double> angles;
};

}  // namespace

int main(int count, char** words) { return cca::robot_main<program>(count, words); }
// [main end]
