// Two environments in two processes, over shared memory. In one terminal
//
//   deployment_two_processes --only robot --shared-memory /leg
//
// and in another the same with `--only mind`; without both options they are two threads of one process. The
// robot's process compares the leg with that of one loop, bit for bit. Kill one of them, and the other stops
// with a fault; a signal ends both in order. Pages: docs/environments.md, docs/programs.md.
#include <cstdio>
#include <vector>

#include <cca/main.hpp>

#include "thoughtful_leg.hpp"

namespace {

// [program]
struct program : cca::robot_program<split> {
  program() {
    purpose = "a leg and its thoughts, in two threads or two processes";
    settings.seconds = 0.3;
    settings.speed.reset();  // as fast as possible
  }

  bool between(controller_type& c) override {
    if (runs("robot")) angles.push_back(c.get<"leg">().angle);
    return true;
  }

  int finish(controller_type& c) override { return runs("robot") ? compare(c) : 0; }

  // [program end]
  // At wall-clock speed samples may be late; then the leg is another one.
  int compare(const controller_type& c) const {
    std::vector<double> expected;
    cca::controller<thoughtful_leg> one_loop;
    one_loop.load();
    one_loop.start();
    one_loop.run(cca::for_some_beats{static_cast<std::int64_t>(angles.size())}, {},
                 [&](auto& running) { expected.push_back(running.template get<"leg">().angle); });
    const bool was_late = c.late() > 0 || c.lost_periods() > 0;
    std::printf("%zu beats, %s\n", angles.size(),
                angles == expected ? "bit for bit as in one loop"
                : was_late         ? "and some samples were late"
                                   : "NOT as in one loop");
    return angles == expected || was_late ? 0 : 1;
  }

  // [main]
  std::vector<double> angles;
};

}  // namespace

int main(int count, char** words) { return cca::robot_main<program>(count, words); }
// [main end]
