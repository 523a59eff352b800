#pragma once
// What the programs that act once have in common: the command line, files, and what they return when something is refused.
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "command_line.hpp"

namespace skills {

template <class Write>
void write(const std::string& name, Write content) {
  std::ofstream file(name);
  if (file) content(file);
  file.close();
  if (!file) throw std::runtime_error(name + ": cannot be written");
}

// What run(options) returns; 2 where the command line is refused, 3 where anything else is.
template <class Run>
int program(const char* name, int count, char** arguments, Run run) {
  try {
    const options o = parse({arguments + 1, arguments + count});
    if (o.help) {
      std::cout << usage;
      return 0;
    }
    return run(o);
  } catch (const command_line_error& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 3;
  }
}

}  // namespace skills
