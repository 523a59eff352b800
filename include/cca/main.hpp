// A main function for robots: parameters from files, how long, how fast, which environments, over which
// transport, an orderly stop at a signal, figures at the end, and an exit code.
//
//   int main(int count, char** words) { return cca::robot_main<split>(count, words); }
//
//   trot --config trot.toml --seconds 10
//   trot --only robot --shared-memory /trot
//
// `split` is a graph, a deployment, or a cca::robot_program of one, with options and output of its own. The
// exit codes are in cca/main/run_program.hpp. Needs toml++ and CLI11: the target cca::main.
// Test: tests/runtime/programs/robot_main.cpp; docs/programs.md.
#pragma once

#include <string>

#include <cca/main/command_line.hpp>
#include <cca/main/robot_program.hpp>
#include <cca/main/robot_run.hpp>
#include <cca/main/run_program.hpp>
#include <cca/main/standard_options.hpp>

namespace cca {

// For a main function that reads the command line itself and chooses among programs.
// The options of a door (docs/door.md), if there is one; `s` becomes the settings of the program that runs.
template <class Controller>
void offer_door([[maybe_unused]] command_line& line, [[maybe_unused]] run_settings& s) {
  if constexpr (detail::HasDoor<Controller>) detail::offer_door(line, s);
}

// Likewise `--replay`, if <cca/record/replay_option.hpp> is included.
template <class Controller>
void offer_replay([[maybe_unused]] command_line& line, [[maybe_unused]] run_settings& s) {
  if constexpr (detail::HasReplay<Controller>) detail::offer_replay(line, s);
}

// Runs the robot of a program by its settings. Returns the exit code; what is refused is thrown.
template <class Program>
int run_robot(Program& program, const std::string& name) {
  detail::refuse_contradictions(program.settings);
  return detail::robot_run<Program>(program, name).go();
}

template <class Program>
int robot_main(int count, char** words) {
  if constexpr (!detail::RobotProgram<Program>) {
    return robot_main<robot_program<Program>>(count, words);
  } else {
    Program program;
    command_line line(program.purpose);
    program.options(line);
    detail::offer_standard_options(line, program);
    for (int word = 0; word < count; ++word)
      program.settings.notes["command_line"].append(word > 0 ? " " : "").append(words[word]);
    return run_program(count, words, line, [&] {
      detail::refuse_contradictions(line, program);
      return run_robot(program, program_name(count, words));
    });
  }
}

}  // namespace cca
