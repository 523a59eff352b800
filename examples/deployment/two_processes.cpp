// Two environments in two processes, over shared memory: in one terminal `deployment_two_processes robot`, in
// another `deployment_two_processes mind`. Without an argument it starts both, and compares the leg with that
// of one loop, bit for bit. Kill one of them, and the other stops with a fault. Pages: docs/environments.md.
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <exception>
#include <vector>

#include "thoughtful_leg.hpp"

namespace {

constexpr const char* memory = "/cca_thoughtful_leg";

// [processes]
int run_robot(std::vector<double>& angles) {
  cca::deployed<split> d(cca::only{"robot"}, cca::shared_memory(memory));
  d.load();
  d.start();
  d.run(cca::for_<0.3>{}, {}, [&](auto& running) { angles.push_back(running.template get<"leg">().angle); });
  return d.fault() ? 1 : 0;
}

int run_mind() {
  cca::deployed<split> d(cca::only{"mind"}, cca::shared_memory(memory));
  d.load();
  d.start();
  d.run(cca::without_end{});  // the robot ends it
  return d.fault() ? 1 : 0;
}
// [processes end]

// Runs `robot` here and `mind` in a child, and compares the angles.
int run_both() {
  const pid_t mind = ::fork();
  if (mind == 0) ::_exit(run_mind());
  std::vector<double> angles, expected;
  const int failed = run_robot(angles);
  int status = 0;
  ::waitpid(mind, &status, 0);

  cca::controller<thoughtful_leg> one_loop;
  one_loop.load();
  one_loop.start();
  one_loop.run(cca::for_<0.3>{}, {},
               [&](auto& running) { expected.push_back(running.template get<"leg">().angle); });
  std::printf("%zu beats in two processes, %s\n", angles.size(),
              angles == expected ? "bit for bit as in one loop" : "NOT as in one loop");
  return failed || status != 0 || angles != expected;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    std::vector<double> angles;
    if (count == 1) return run_both();
    if (count == 2 && std::strcmp(arguments[1], "robot") == 0) return run_robot(angles);
    if (count == 2 && std::strcmp(arguments[1], "mind") == 0) return run_mind();
    std::fprintf(stderr, "usage: deployment_two_processes [robot | mind]\n");
    return 2;
  } catch (const std::exception& refusal) {
    std::fprintf(stderr, "%s\n", refusal.what());
    return 1;
  }
}
