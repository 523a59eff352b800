// The functions that read what the user types. run_commands.hpp includes this, unless they are compiled
// once for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <poll.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cstddef>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include <cca/main/run_commands.hpp>

namespace cca::detail {

CCA_MAIN_INLINE run_commands::run_commands(run_control& of, std::string name, bool anyway)
    : control(of), called(std::move(name)) {
  if (anyway || ::isatty(STDIN_FILENO) == 1) reader = std::thread([this, anyway] { read(anyway); });
}

CCA_MAIN_INLINE run_commands::~run_commands() {
  ends.store(true, std::memory_order_release);
  if (reader.joinable()) reader.join();
}

CCA_MAIN_INLINE std::string run_commands::obey(run_control& control, std::string_view line) {
  while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.remove_suffix(1);
  while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
  if (line.empty()) return {};
  if (line == "p" || line == "pause") return control.pause(), std::string();
  if (line == "g" || line == "go") return control.go_on(), std::string();
  if (line == "s" || line == "step") {
    if (control.is_pause_wanted()) control.step();
    else control.pause();
    return {};
  }
  if (line == "r" || line == "resume") return control.ask_anew(begun_anew::wish::resume);
  if (line == "start") return control.ask_anew(begun_anew::wish::start);
  std::string unknown = "`" + std::string(line) +
                        "` is no command: p pauses, g goes on, s makes one beat, r resumes after a "
                        "fault, start begins anew, a number from 0.001 to 1000 is the speed";
  if (line.starts_with("x ")) line.remove_prefix(2);
  double speed = 0;
  const auto read = std::from_chars(line.data(), line.data() + line.size(), speed);
  if (read.ec != std::errc{} || read.ptr != line.data() + line.size()) return unknown;
  if (!(speed >= 1e-3 && speed <= 1e3)) return unknown;
  return control.set_speed(speed), std::string();
}

CCA_MAIN_INLINE void run_commands::read(bool anyway) {
  constexpr int looks_every = 50;  // ms
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

CCA_MAIN_INLINE void run_commands::take(const std::string& line) {
  if (const std::string why = obey(control, line); !why.empty()) std::cerr << called + ": " + why + '\n';
}

}  // namespace cca::detail
