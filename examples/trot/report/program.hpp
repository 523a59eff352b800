#pragma once
// Shared by all example programs: writing files, --help and --version, and the exit codes for refused input.
#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <cca/version.hpp>

#include "option_reader.hpp"

namespace trot {

template <class Write>
void write(const std::string& name, Write content) {
  std::ofstream file(name);
  if (file) content(file);
  file.close();
  if (!file) throw std::runtime_error(name + ": cannot be written");
}

// Prints `help` for --help and -h, the version for --version; otherwise returns what act(arguments)
// returns; 2 if the command line is refused, 3 for any other error.
template <class Act>
int program(const char* name, std::string_view help, int count, char** words, Act act) {
  const std::vector<std::string> arguments(words + 1, words + count);
  const auto asks_for = [&](const char* word) {
    return std::find(arguments.begin(), arguments.end(), word) != arguments.end();
  };
  if (asks_for("--help") || asks_for("-h")) return std::cout << help, 0;
  if (asks_for("--version")) {
    std::cout << name << " (cca " << cca::version_major << '.' << cca::version_minor << '.'
              << cca::version_patch << ")\n";
    return 0;
  }
  try {
    return act(arguments);
  } catch (const command_line_error& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 3;
  }
}

}  // namespace trot
