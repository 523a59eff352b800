#pragma once
// Shared by the programs that do one run: the command line.
#include <iostream>

#include "../trot/report/program.hpp"
#include "command_line.hpp"

namespace skills {

// Returns what run(options) returns, or an exit code of trot::program.
template <class Run>
int program(const char* name, int count, char** arguments, Run run) {
  return trot::program(name, [&] {
    const options o = parse({arguments + 1, arguments + count});
    if (!o.help) return run(o);
    std::cout << usage;
    return 0;
  });
}

}  // namespace skills
