// The Combination of Skills on drives: the Oncilla trots, stops, reaches for a ball and trots on, over five buses in memory. Options are
// those of combination_of_skills, without its recordings; --help lists them.
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include <cca/cca.hpp>
#include <cca/config.hpp>

#include "../combination_of_skills/summary.hpp"
#include "on_drives.hpp"

namespace {

int run(const skills::options& o) {
  if (o.csv || o.svg) throw skills::command_line_error("--csv and --svg: only combination_of_skills records");
  hil::skills_in_memory robot;
  hil::load(robot, o.shape, o.config);
  const auto result = skills::act(robot, o.run, [](const auto&) {});
  if (!o.quiet) skills::write_table(std::cout, o.run, result);
  if (o.summary) {
    std::ofstream file(*o.summary);
    if (file) skills::write_json(file, {{o.run, result}});
    file.close();
    if (!file) throw std::runtime_error(*o.summary + ": cannot be written");
  }
  const auto& stop = robot.controller.get<"robot.emergency_stop">();
  if (stop.mode() != cca::hardware::motion_mode::run)
    std::printf("stopped; first cause: %s\n", std::string(cca::hardware::name_of(stop.first_cause().rule)).c_str());
  return skills::succeeded(result) ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const skills::options options = skills::parse({arguments + 1, arguments + count});
    if (options.help) {
      std::cout << skills::usage;
      return 0;
    }
    return run(options);
  } catch (const skills::command_line_error& error) {
    std::cerr << "hardware_in_the_loop_skills: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "hardware_in_the_loop_skills: " << error.what() << '\n';
    return 3;
  }
}
