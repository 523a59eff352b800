// cca-call: one call to the door of a running program, for scripts. docs/door_tools.md; `cca-call --help`.
#include <iostream>

#include <cca/main/run_program.hpp>

#include "commands.hpp"

int main(int count, char** words) {
  cca_door::call_options o;
  cca::command_line line("asks a running program through its door, or tells it what to do");
  o.add_to(line);
  return cca::run_program(count, words, line, [&] { return cca_door::run_call(o, std::cout, std::cerr); });
}
