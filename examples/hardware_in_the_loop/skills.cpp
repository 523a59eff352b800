// The Combination of Skills on drives: the Oncilla trots, stops, reaches for a ball and trots on, over five
// buses in memory. The options are those of combination_of_skills without recordings; --help lists them.
#include <cstdio>
#include <iostream>
#include <string>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/runtime/interruption.hpp>

#include "../combination_of_skills/program.hpp"
#include "../combination_of_skills/summary.hpp"
#include "on_drives.hpp"

namespace {

int run(const skills::options& o) {
  if (o.csv || o.svg) throw skills::command_line_error("--csv and --svg: only combination_of_skills records");
  hil::skills_in_memory robot;
  hil::load(robot, o.shape, o.config);
  const cca::interruption interrupted;  // ctrl-c: the drives are stopped, and what it has is written
  const auto result = skills::act(robot, o.run, [&](const auto&) { return !interrupted; });
  if (!o.quiet) skills::write_table(std::cout, o.run, result);
  if (o.summary)
    trot::write(*o.summary, [&](std::ostream& file) { skills::write_json(file, {{o.run, result}}); });
  const auto& stop = robot.controller.get<"robot.emergency_stop">();
  if (stop.mode() != cca::hardware::motion_mode::run)
    std::printf("stopped; first cause: %s\n",
                std::string(cca::hardware::name_of(stop.first_cause().rule)).c_str());
  const auto stopped = robot.shut_down();
  if (!o.quiet || !stopped.complete()) std::printf("%s\n", stopped.text().c_str());
  return interrupted ? interrupted.exit_code() : skills::succeeded(result) ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  return skills::program("hardware_in_the_loop_skills", count, arguments, run);
}
