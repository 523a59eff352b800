#pragma once
// What the programs that act once have in common: the command line.
#include <iostream>

#include "../trot/report/program.hpp"
#include "command_line.hpp"

namespace skills {

// What run(options) returns, or trot::program.
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
