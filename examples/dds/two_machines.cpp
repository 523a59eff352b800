// Two environments on two machines, over Cyclone DDS: on one `dds_two_machines robot`, on the other
// `dds_two_machines mind`, both with CYCLONEDDS_URI (docs/transports.md). Without that variable both run on
// this machine. Without an argument it starts both here, and compares the leg with that of one loop, bit for
// bit.
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include <cca/dds.hpp>
#include <cca/main/command_line.hpp>
#include <cca/main/run_program.hpp>

#include "../deployment/thoughtful_leg.hpp"

namespace {

// [dds]
int run_robot(const cca::dds::domain& net, std::vector<double>& angles) {
  cca::deployed<split> d(cca::only{"robot"}, net);
  d.load();
  d.start();
  d.run(cca::for_<0.3>{}, {}, [&](auto& running) { angles.push_back(running.template get<"leg">().angle); });
  for (const auto& one : net.refusals())
    std::printf("refused from %s: %s (%lld times)\n", one.who.c_str(), one.why.c_str(),
                static_cast<long long>(one.count));
  return d.fault() ? 1 : 0;
}

int run_mind(const cca::dds::domain& net) {
  cca::deployed<split> d(cca::only{"mind"}, net);
  d.load();
  d.start();
  d.run(cca::without_end{});  // the robot ends it
  return d.fault() ? 1 : 0;
}
// [dds end]

constexpr std::uint32_t domain_number = 7;

// Runs `robot` here and `mind` in a child, in a partition of their own, and compares the angles.
int run_both() {
  const cca::dds::domain net(domain_number, "two_machines_" + std::to_string(::getpid()));
  const pid_t mind = ::fork();
  if (mind == 0) ::_exit(run_mind(net));
  std::vector<double> angles, expected;
  const int failed = run_robot(net, angles);
  int status = 0;
  ::waitpid(mind, &status, 0);

  cca::controller<thoughtful_leg> one_loop;
  one_loop.load();
  one_loop.start();
  one_loop.run(cca::for_<0.3>{}, {},
               [&](auto& running) { expected.push_back(running.template get<"leg">().angle); });
  std::printf("%zu beats in two processes over DDS, %s\n", angles.size(),
              angles == expected ? "bit for bit as in one loop" : "NOT as in one loop");
  return failed || status != 0 || angles != expected;
}

}  // namespace

int main(int count, char** words) {
  cca::command_line line("two environments on two machines, over Cyclone DDS");
  std::vector<std::string> given;
  line.words("[ENVIRONMENT]", given, 1,
             "robot or mind: runs it here (both, and compares them with one loop)");
  return cca::run_program(count, words, line, [&] {
    if (given.empty()) return run_both();
    const cca::dds::domain net(domain_number);
    std::vector<double> angles;
    if (given[0] == "robot") return run_robot(net, angles);
    if (given[0] == "mind") return run_mind(net);
    throw cca::command_line_error(given[0] + ": expected robot or mind");
  });
}
