#pragma once
// Shared by the programs that do one run: the command line.
#include <string>
#include <vector>

#include "../trot/report/program.hpp"
#include "command_line.hpp"

namespace skills {

// Returns what run(options) returns, or an exit code of trot::program.
template <class Run>
int program(const char* name, int count, char** arguments, Run run) {
  return trot::program(name, usage, count, arguments,
                       [&](const std::vector<std::string>& given) { return run(parse(given)); });
}

}  // namespace skills
