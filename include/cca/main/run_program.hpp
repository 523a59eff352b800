// What each program does around its work: it answers --help, -h and --version, refuses a wrong command line
// in words, and turns exceptions into messages and exit codes.
//
//   int main(int count, char** words) {
//     options o;
//     cca::command_line line("learns the shape of a trot");
//     line.text("--out FILE", o.out, "the learned shape (trot.shape)");
//     return cca::run_program(count, words, line, [&] { return learn(o); });
//   }
//
// Test: tests/runtime/programs/command_line.cpp; docs/programs.md.
#pragma once

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/main/command_line.hpp>
#include <cca/version.hpp>

namespace cca {

// A signal that ended the program in order gives 128 and its number (cca::interruption): 129, 130, 143.
namespace exit_code {
inline constexpr int done = 0;
inline constexpr int fault = 1;    // a component's, lost contact, or what the program counts as a failure
inline constexpr int refused = 2;  // the command line, a parameter file, or what the system does not allow
inline constexpr int error = 3;    // anything else, as a file that can't be written
}  // namespace exit_code

inline std::string program_name(int count, char** words) {
  const std::string path = count > 0 ? words[0] : "program";
  return path.substr(path.rfind('/') + 1);
}

// Returns what act() returns, or the exit code of what it throws. Output that nobody reads, or that has no
// room, changes nothing but a message.
template <class Act>
int run_program(int count, char** words, command_line& line, Act act) {
  const std::string name = program_name(count, words);
  const std::vector<std::string> arguments(words + std::min(count, 1), words + count);
  const auto asks_for = [&](const char* word) {
    return std::ranges::find(arguments, word) != arguments.end();
  };
  if (asks_for("--help") || asks_for("-h")) return std::cout << line.help(name), exit_code::done;
  if (asks_for("--version")) {
    std::cout << name << " (cca " << version_major << '.' << version_minor << '.' << version_patch << ")\n";
    return exit_code::done;
  }
  const auto tell = [&name](const std::exception& e) { std::cerr << name << ": " << e.what() << '\n'; };
  const auto acted = [&] {
    const int code = line.work_instead() ? line.work_instead()() : act();
    std::cout.flush();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      std::cerr << name + ": what it printed is not complete: its standard output is closed or full\n";
    return code;
  };
  try {
    line.parse(arguments);
    return acted();
  } catch (const command_line_error& e) {
    return tell(e), exit_code::refused;
  } catch (const cca::refused& e) { return tell(e), exit_code::refused; } catch (const std::exception& e) {
    return tell(e), exit_code::error;
  }
}

}  // namespace cca
