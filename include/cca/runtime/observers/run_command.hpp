// What a program can be asked to do while it runs, beside what every run knows: a push of a simulated robot,
// a jog of an axis. A door offers it to whoever holds the right to command (docs/door.md).
//
//   pushing() {
//     offers.push_back({.name = "push", .help = "pushes the trunk",
//                       .arguments = {{"forward", 20, -60, 60, "N"}},
//                       .begin = [](auto& c, auto newtons) { ... },
//                       .end = [](auto& c) { ... }});
//   }
//
// Both functions run between two beats, in the thread of the loop; of a deployment in that of its first
// environment. With an `end` the command is held: it ends when it is released, or when the one who holds it
// is gone.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace cca {

template <class Controller>
struct run_command {
  // In SI units; `value` is the one that a form shows first.
  struct argument {
    std::string name;
    double value = 0, lower = 0, upper = 0;
    std::string unit{};
  };
  static constexpr std::size_t most_arguments = 8;

  std::string name, help{};
  std::vector<argument> arguments{};
  std::function<void(Controller&, std::span<const double>)> begin{};
  std::function<void(Controller&)> end{};
  bool only_at_rest = false;  // refused while it runs: in a pause, or where there is no beat
};

}  // namespace cca
