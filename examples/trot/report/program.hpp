#pragma once
// Shared by all example programs: writing files, and the exit codes for refused input.
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

// Returns what act() returns; 2 if the command line is refused, 3 for any other error.
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
