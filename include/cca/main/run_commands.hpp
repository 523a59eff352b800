// What the user of a robot's program types while it runs: a line each.
//
//   p, pause    pauses after the beat; the robot goes on getting frames (on_idle)
//   g, go       goes on
//   s, step     one beat, in a pause
//   r, resume   goes on after a fault that is held
//   start       makes the first beat; begins anew after a fault that is held, and in a pause
//   0.5, x 0.5  the speed, times the clock
//
// They are read where the standard input is a terminal in whose foreground the program is: one that runs in
// the background must not be stopped by the terminal. `--commands` reads them from any standard input.
// Errors: a line that is none of these is answered on the error output. Cost: a thread that sleeps.
// docs/programs.md.
#pragma once

#include <atomic>
#include <string>
#include <string_view>
#include <thread>

#include <cca/base/separate/compiled.hpp>
#include <cca/runtime/run_record.hpp>

namespace cca::detail {

class run_commands {
public:
  // `anyway`: also where the standard input is no terminal.
  run_commands(run_control& of, std::string name, bool anyway);
  ~run_commands();
  run_commands(const run_commands&) = delete;
  run_commands& operator=(const run_commands&) = delete;

  // Why not; empty: it is done. For tests.
  static std::string obey(run_control& control, std::string_view line);

private:
  void read(bool anyway);
  void take(const std::string& line);

  run_control& control;
  std::string called;
  std::atomic<bool> ends{false};
  std::thread reader;
};

}  // namespace cca::detail

#if !CCA_HAS_COMPILED_MAIN
#include <cca/main/run_commands_functions.hpp>
#endif
