#pragma once
// What the programs of the examples have in common: files, and what they return when something is refused.
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "command_line.hpp"

namespace trot {

template <class Write>
void write(const std::string& name, Write content) {
  std::ofstream file(name);
  if (file) content(file);
  file.close();
  if (!file) throw std::runtime_error(name + ": cannot be written");
}

// What act() returns; 2 where the command line is refused, 3 where anything else is.
template <class Act>
int program(const char* name, Act act) {
  try {
    return act();
  } catch (const command_line_error& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 3;
  }
}

}  // namespace trot
