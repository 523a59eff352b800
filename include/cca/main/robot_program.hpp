// What a program adds to the main function for robots (cca/main.hpp): each virtual function is a place where
// it may do something, none is needed.
//
//   struct trotting : cca::robot_program<simulated_trot> {
//     trotting() { purpose = "a simulated Oncilla trots"; settings.seconds = 20; }
//     void options(cca::command_line& line) override { line.text("--csv FILE", csv, "every fifth beat"); }
//     bool between(controller_type& c) override { ... return !has_fallen(c); }
//     std::string csv;
//   };
//   int main(int count, char** words) { return cca::robot_main<trotting>(count, words); }
//
//   Architecture   a graph, which runs in a cca::controller, or a deployment, which runs in a cca::deployed
//
// `between` runs in the thread of the loop, between two beats; the rest before the first beat and after the
// last. docs/programs.md.
#pragma once

#include <algorithm>
#include <concepts>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <cca/base/type_name.hpp>
#include <cca/component/lifecycle.hpp>
#include <cca/main/command_line.hpp>
#include <cca/runtime/observers/run_command.hpp>
#include <cca/main/run_settings.hpp>
#include <cca/runtime/environments/deployed.hpp>
#include <cca/runtime/environments/only.hpp>

namespace cca {

template <class Architecture>
class robot_program {
public:
  using architecture = Architecture;
  using controller_type =
      std::conditional_t<AnyDeployment<Architecture>, deployed<Architecture>, controller<Architecture>>;

  static_assert(sizeof(controller_type) != 0);  // what breaks a rule says so here, before all else

  std::string purpose = "runs " + std::string(detail::type_name<Architecture>());  // the first line of --help
  run_settings settings{};

  robot_program() = default;
  robot_program(const robot_program&) = delete;
  robot_program& operator=(const robot_program&) = delete;
  virtual ~robot_program() = default;

  // Options of its own. One of the same name takes the place of a standard option.
  virtual void options(command_line&) {}
  // The controller is new: connect buses, name the files that components load.
  virtual void prepare(controller_type&) {}
  // The parameters are loaded: change them, put a robot down.
  virtual void loaded(controller_type&) {}
  // It is started, also anew: its first beat comes next.
  virtual void started(controller_type&) {}
  // After each beat; false ends the run. What it may touch: docs/environments.md.
  virtual bool between(controller_type&) { return true; }
  // Once a period in which there is no beat, the robot has idled: before the first one with --paused, and
  // after a fault with --on-fault hold.
  virtual void rests(controller_type&) {}
  // However the run has ended, a fault and an exception too. A robot on drives: cca::hardware::shut_down.
  // Another process may have stopped a deployment already.
  virtual void stop(controller_type& c) {
    if (c.state() == state::started || c.state() == state::faulted) c.stop();
  }
  // Of another thread, for example: pauses the run, makes single beats, changes the speed.
  detail::run_control control{};
  // What a door offers beside what every run knows. Fill it before the run: in the constructor, or in
  // `loaded`.
  std::vector<run_command<controller_type>> offers{};

  // Prints and writes what it has. Its exit code counts if neither a fault nor a signal has ended the run.
  virtual int finish(controller_type&) { return 0; }

  // Whether this process runs an environment.
  bool runs(std::string_view environment) const {
    return settings.only.empty() || std::ranges::find(settings.only, environment) != settings.only.end();
  }

  // An option by which this process reaches the other environments. In `options`, one line for each
  // transport:
  //   transport<cca::dds::domain>(line, "--dds DOMAIN", "reaches the others by DDS, in this domain");
  // A transport is made of the text of the option, or of a whole number. `keep(transport)` is called if it is
  // chosen: a program can keep it, and ask it later.
  template <class Transport>
    requires AnyDeployment<Architecture>
  void transport(command_line& line,
                 std::string_view option,
                 std::string_view help,
                 std::function<void(const Transport&)> keep = {}) {
    const std::string name(option.substr(0, option.find(' ')));
    others.offered.emplace_back(option);
    line.value(
        option,
        [this, name, keep = std::move(keep)](const std::string& text) {
          if (others.open) throw command_line_error(name + " and " + others.chosen + ": take one of them");
          others.chosen = name;
          const auto opens = [&](const Transport& by) {
            if (keep) keep(by);
            others.open = [by](const only& here) { return std::make_unique<controller_type>(here, by); };
          };
          if constexpr (std::constructible_from<Transport, std::string>) opens(Transport(text));
          else
            opens(
                Transport(static_cast<int>(whole_number_in(name, text, 0, std::numeric_limits<int>::max()))));
        },
        help);
  }

  // For robot_main: how this process reaches the others.
  struct {
    std::vector<std::string> offered{};
    std::string chosen{};
    std::function<std::unique_ptr<controller_type>(const only&)> open{};
  } others;
};

namespace detail {

template <class Type> concept RobotProgram = requires {
  typename Type::architecture;
} && std::derived_from<Type, robot_program<typename Type::architecture>>;

}  // namespace detail
}  // namespace cca
