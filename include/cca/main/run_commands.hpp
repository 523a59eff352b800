// What the user of a robot's program types while it runs: a line each.
//
//   p, pause    pauses after the beat; the robot goes on getting frames (on_idle)
//   g, go       goes on
//   s, step     one beat, in a pause
//   0.5, x 0.5  the speed, times the clock
//
// They are read where the standard input is a terminal in whose foreground the program is: one that runs in
// the background must not be stopped by the terminal. `--commands` reads them from any standard input.
// Errors: a line that is none of these is answered on the error output. Cost: a thread that sleeps.
// docs/programs.md.
#pragma once

#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <charconv>
#include <chrono>
#include <cstddef>
#include <iostream>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include <cca/runtime/run_record.hpp>

namespace cca::detail {

class run_commands {
public:
  // `anyway`: also where the standard input is no terminal.
  run_commands(run_control& of, std::string name, bool anyway) : control(of), called(std::move(name)) {
    if (anyway || ::isatty(STDIN_FILENO) == 1) reader = std::thread([this, anyway] { read(anyway); });
  }
  ~run_commands() {
    ends.store(true, std::memory_order_release);
    if (reader.joinable()) reader.join();
  }
  run_commands(const run_commands&) = delete;
  run_commands& operator=(const run_commands&) = delete;

  // False: it is no command. For tests.
  static bool obey(run_control& control, std::string_view line) {
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.remove_suffix(1);
    while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
    if (line.empty()) return true;
    if (line == "p" || line == "pause") return control.pause(), true;
    if (line == "g" || line == "go") return control.go_on(), true;
    if (line == "s" || line == "step") {
      if (control.is_paused()) control.step();
      else control.pause();
      return true;
    }
    if (line.starts_with("x ")) line.remove_prefix(2);
    double speed = 0;
    const auto read = std::from_chars(line.data(), line.data() + line.size(), speed);
    if (read.ec != std::errc{} || read.ptr != line.data() + line.size()) return false;
    if (!(speed >= 1e-3 && speed <= 1e3)) return false;
    return control.set_speed(speed), true;
  }

private:
  static constexpr int looks_every = 50;  // ms

  void read(bool anyway) {
    std::string line;
    for (char letters[256]; !ends.load(std::memory_order_acquire);) {
      if (!anyway && ::tcgetpgrp(STDIN_FILENO) != ::getpgrp()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(looks_every));
        continue;
      }
      pollfd input{STDIN_FILENO, POLLIN, 0};
      if (::poll(&input, 1, looks_every) <= 0) continue;
      const ssize_t count = ::read(STDIN_FILENO, letters, sizeof letters);
      if (count <= 0) return;  // it is closed
      for (const char letter : std::string_view(letters, static_cast<std::size_t>(count)))
        if (letter == '\n') take(std::exchange(line, {}));
        else if (line.size() < sizeof letters) line.push_back(letter);
    }
  }
  void take(const std::string& line) {
    if (!obey(control, line))
      std::cerr
          << called + ": `" + line +
                 "` is no command: p pauses, g goes on, s makes one beat, a number from 0.001 to 1000 is the "
                 "speed\n";
  }

  run_control& control;
  std::string called;
  std::atomic<bool> ends{false};
  std::thread reader;
};

}  // namespace cca::detail
