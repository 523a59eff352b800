// The command line of cca-call.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/nearest.hpp>
#include <cca/main/command_line.hpp>

#include "../address.hpp"

namespace cca_door {

struct call_options {
  door_address door{};
  token_option token{};
  std::string command{};
  std::vector<std::string> words{};  // after the command
  bool json = false;
  std::uint64_t count = 0;           // 0: no end
  std::optional<double> hold_for{};  // s
  double answers_within = 10;        // s
  std::vector<std::string> all_words{};

  void add_to(cca::command_line& line);
  void split();
};

struct call_command {
  std::string_view name, arguments, help;
  std::size_t least, most;  // words after it
};
inline constexpr std::size_t any_number = 1000;
inline constexpr call_command call_commands[] = {
    {"get", "[NAME...]", "values of parameters, one a line, with --json as an object", 0, any_number},
    {"set", "NAME VALUE ...", "all in one beat, or none; also NAME=VALUE", 1, any_number},
    {"undo", "", "takes back the last change of parameters", 0, 0},
    {"load", "FILE [SCOPE]", "parameters from a file of the program's folder", 1, 2},
    {"save", "FILE [SCOPE]", "parameters into a file of the program's folder", 1, 2},
    {"status", "", "state, beats, environments; --json", 0, 0},
    {"describe", "", "nodes, outputs, parameters with units and ranges, commands; --json", 0, 0},
    {"watch", "OUTPUT", "prints its samples; --count N, --json", 1, 1},
    {"pause", "", "the loop waits; the robot's loop goes on where it must", 0, 0},
    {"go-on", "", "ends a pause", 0, 0},
    {"step", "[BEATS]", "so many beats of a run that is paused (1)", 0, 1},
    {"speed", "FACTOR", "times the clock, 0.001 to 1000, of a wall-clock run", 1, 1},
    {"mode", "MODE", "switches to another mode", 1, 1},
    {"stop", "[PART]", "ends the run, whoever commands; with PART stops that part", 0, 1},
    {"start", "[PART]",
     "makes the first beat, or begins anew after a fault or in a pause; with PART that part", 0, 1},
    {"resume", "", "goes on after a fault that is held", 0, 0},
    {"record", "FILE", "begins a recording, into a file of the program's folder", 1, 1},
    {"end-recording", "", "and ends it", 0, 0},
    {"command", "NAME [ARGUMENT=VALUE...]", "a command of the program; a held one until ctrl-c or --for S", 1,
     any_number},
    {"test", "INPUT OUTPUT SIGNAL [NAME=VALUE...]",
     "adds step, sine or chirp to an input, prints gain and phase to the output; --json", 3, any_number},
    {"release", "NAME", "ends the effect of a command", 1, 1},
};

inline void call_options::add_to(cca::command_line& line) {
  std::string what = "the door, as 8765 or 192.168.1.5:8765, and what to do:";
  for (const call_command& one : call_commands) {
    std::string use = std::string(one.name) + (one.arguments.empty() ? "" : " " + std::string(one.arguments));
    use.resize(std::max<std::size_t>(use.size() + 2, 32), ' ');
    what += "\n" + use + std::string(one.help);
  }
  line.words("PORT COMMAND", all_words, any_number, what);
  token.add_to(line);
  line.flag("--json", json, "get, status, describe, watch, test: prints JSON");
  line.whole_number("--count N", count, 1, "watch: ends after N samples");
  line.number("--for S", hold_for, 0, 1e6, "command: holds it so many seconds");
  line.number("--timeout S", answers_within, 0.01, 600,
              "how long it waits for a connection or an answer (10)");
}

// The words into the address, the command and its arguments; what is wrong is refused.
inline void call_options::split() {
  if (all_words.size() < 2)
    throw cca::command_line_error("expected a port and a command, as `8765 get`; see --help");
  door = address_in(all_words[0]);
  command = all_words[1];
  words.assign(all_words.begin() + 2, all_words.end());
  std::vector<std::string_view> names;
  const call_command* of = nullptr;
  for (const call_command& one : call_commands) {
    names.push_back(one.name);
    if (one.name == command) of = &one;
  }
  if (!of) {
    const std::string_view near = cca::detail::nearest_name(command, names);
    throw cca::command_line_error(
        "there is no command `" + command + "`" +
        (near.empty() ? "; see --help" : ", did you mean `" + std::string(near) + "`?"));
  }
  if (words.size() < of->least || words.size() > of->most)
    throw cca::command_line_error("expected `" + command + (of->arguments.empty() ? "" : " ") +
                                  std::string(of->arguments) + "`");
  const auto only = [&](bool is_given, const char* option, std::initializer_list<std::string_view> commands) {
    if (is_given && std::find(commands.begin(), commands.end(), command) == commands.end())
      throw cca::command_line_error(std::string(option) + " does nothing with `" + command + "`; see --help");
  };
  only(json, "--json", {"get", "status", "describe", "watch", "test"});
  only(count > 0, "--count", {"watch"});
  only(hold_for.has_value(), "--for", {"command"});
}

}  // namespace cca_door
