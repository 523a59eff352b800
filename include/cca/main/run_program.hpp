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

#include <string>

#include <cca/base/separate/compiled.hpp>
#include <cca/base/separate/function_ref.hpp>
#include <cca/main/command_line.hpp>

namespace cca {

// A signal that ended the program in order gives 128 and its number (cca::interruption): 129, 130, 143.
namespace exit_code {
inline constexpr int done = 0;
inline constexpr int fault = 1;    // a component's, lost contact, or what the program counts as a failure
inline constexpr int refused = 2;  // the command line, a parameter file, or what the system does not allow
inline constexpr int error = 3;    // anything else, as a file that can't be written
}  // namespace exit_code

std::string program_name(int count, char** words);

namespace detail {

int run_program(int count, char** words, command_line& line, function_ref<int()> act);

}  // namespace detail

// Returns what act() returns, or the exit code of what it throws. Output that nobody reads, or that has no
// room, changes nothing but a message.
template <class Act>
int run_program(int count, char** words, command_line& line, Act act) {
  const auto called = [&]() -> int { return act(); };
  return detail::run_program(count, words, line, detail::function_ref<int()>(called));
}

}  // namespace cca

#if !CCA_HAS_COMPILED_MAIN
#include <cca/main/run_program_functions.hpp>
#endif
