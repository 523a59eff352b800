// The words of a command line, read by CLI11. A command takes the options and words that it needs;
// `nothing_left` complains about the rest.
//
// `@file` stands for the words in that file, where `#` begins a comment: so a robot's limits can be kept in a
// file. The options of each command are those of `known_options`. Errors: usage_error, which says what was
// expected.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include <cca/base/file.hpp>
#include <cca/base/nearest.hpp>
#include <cca/version.hpp>

#include "ending.hpp"

namespace cca_can {

// The whole text must be a number. "0x" numbers are integers.
inline std::optional<double> number_in(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || end != text.c_str() + text.size() || !std::isfinite(value)) return {};
  return value;
}

inline std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t to = text.find(at);
    parts.emplace_back(text.substr(0, to));
    if (to == text.npos) return parts;
    text.remove_prefix(to + 1);
  }
}

namespace detail {

struct known_command {
  std::string_view name, what;
};
inline constexpr std::array known_commands{
    known_command{"list", "the CAN interfaces; with BUS the drives on it"},
    known_command{"watch", "prints what drives report"},
    known_command{"enable", "enables a drive at its present position, disables it at the end"},
    known_command{"jog", "moves one drive, within limits"},
    known_command{"calibrate", "writes the offset of a joint that stands at a known angle"},
    known_command{"record", "writes a log as candump does"},
    known_command{"replay", "sends a log again"},
    known_command{"pretend", "plays drives on a bus"},
    known_command{"help", "all commands and options"}};

struct known_option {
  std::string_view commands, name, what;  // the commands that have it; of a flag, `what` begins with a blank
};
inline constexpr std::array known_options{
    known_option{"list watch enable jog calibrate record replay pretend", "--yes", " confirms beforehand"},
    known_option{"list watch enable jog calibrate record replay", "--pretend",
                 "a drive that is played; BUS is then `memory`"},
    known_option{"list", "--ask", "families to ask: mit,moteus,robstride,cia402"},
    known_option{"list", "--ids", "numbers to ask, as 1-16"},
    known_option{"list", "--listen", "seconds"},
    known_option{"watch", "--ask", " asks by frames that can't move a motor"},
    known_option{"watch enable record pretend", "--seconds", "seconds, 0 without end"},
    known_option{"jog", "--to", "the angle of the drive, rad"},
    known_option{"jog", "--by", "rad from where it is"},
    known_option{"jog", "--range", "LOW,HIGH: it never leaves these angles, rad"},
    known_option{"jog", "--speed", "rad/s, never more"},
    known_option{"jog", "--torque", "N m, never more"},
    known_option{"jog", "--stiffness", "N m/rad"},
    known_option{"jog", "--damping", "N m s/rad"},
    known_option{"jog", "--hold", "seconds at the end"},
    known_option{"calibrate", "--joint", "name of the joint"},
    known_option{"calibrate", "--at", "the angle at which it stands, rad"},
    known_option{"calibrate", "--file", "the file of offsets"},
    known_option{"calibrate", "--node", "path of the synchronizer"},
    known_option{"calibrate", "--gear", "turns of the drive for one of the joint"},
    known_option{"calibrate", "--sign", "1 or -1"},
    known_option{"calibrate", "--offset", "rad, as in the joint's mounting"},
    known_option{"record", "--file", "the log"},
    known_option{"record", "--frames", "a number of frames"},
    known_option{"replay", "--from", "only frames of this interface in the log"},
    known_option{"replay", "--speed", "times as fast as it was"},
    known_option{"replay", "--fast", " without pauses"},
    known_option{"pretend", "--silent-at", "seconds"},
    known_option{"pretend", "--silent-for", "seconds, 0 for good"},
    known_option{"pretend", "--fault-at", "seconds"},
    known_option{"pretend", "--code", "the firmware's number of the fault"},
    known_option{"pretend", "--load", "N m on each motor"}};

constexpr bool has_command(std::string_view commands, std::string_view name) {
  const auto at = commands.find(name);
  return at != commands.npos && (at == 0 || commands[at - 1] == ' ') &&
         (at + name.size() == commands.size() || commands[at + name.size()] == ' ');
}

// The words, with those of files.
inline std::vector<std::string> with_files(const std::vector<std::string>& line) {
  std::vector<std::string> all;
  for (const std::string& each : line) {
    if (each.size() < 2 || each[0] != '@') {
      all.push_back(each);
      continue;
    }
    std::istringstream text(cca::detail::read_file(each.substr(1)));
    for (std::string one; std::getline(text, one);) {
      std::istringstream parts(one.substr(0, one.find('#')));
      for (std::string word; parts >> word;) all.push_back(word);
    }
  }
  return all;
}

}  // namespace detail

class words {
public:
  explicit words(const std::vector<std::string>& line) {
    CLI::App app("cca-can: CAN buses and the drives on them, by hand", "cca-can");
    app.set_help_flag("-h,--help", "this text");
    app.set_version_flag("--version", "cca-can " + std::to_string(cca::version_major) + "." +
                                          std::to_string(cca::version_minor) + "." +
                                          std::to_string(cca::version_patch));
    app.require_subcommand(0, 1);
    app.allow_extras();
    bool yes = false;
    app.add_flag("--yes", yes, "confirms beforehand");
    for (const auto& command : detail::known_commands) add(app, command);
    auto all = detail::with_files(line);
    std::reverse(all.begin(), all.end());
    try {
      app.parse(all);
    } catch (const CLI::CallForHelp&) {
      const auto parsed = app.get_subcommands();
      is_help = true;
      if (!parsed.empty()) said = parsed[0]->help("cca-can");
      return;
    } catch (const CLI::CallForVersion& version) {
      said = std::string(version.what()) + "\n";
      return;
    } catch (const CLI::ArgumentMismatch& wrong) {
      const std::string text = wrong.what();
      throw usage_error(text.substr(0, text.find(':')) + ": a value is expected after it");
    } catch (const CLI::ParseError& wrong) { throw usage_error(wrong.what()); }
    const auto parsed = app.get_subcommands();
    name_of_command = parsed.empty() ? "help" : parsed[0]->get_name();
    if (yes) flags["--yes"] = true;
    left = app.remaining();
    if (!left.empty()) refuse_command(left.front());
    if (parsed.empty()) return;
    left = parsed[0]->remaining();
    for (const auto& [name, values] : given)
      if (values.size() > 1 && name != "--pretend") throw usage_error(name + ": it stands there twice");
  }

  const std::string& command() const { return name_of_command; }
  // What --help or --version ask for: then there is no command. Empty help: that of the whole program.
  bool wants_help() const { return is_help; }
  const std::string& answer() const { return said; }

  bool flag(const std::string& name) const {
    const auto at = flags.find(name);
    return at != flags.end() && at->second;
  }
  std::optional<std::string> option(std::string_view name) const {
    const auto at = given.find(std::string(name));
    return at == given.end() || at->second.empty() ? std::optional<std::string>() : at->second.front();
  }
  std::vector<std::string> all_of(std::string_view name) const {
    const auto at = given.find(std::string(name));
    return at == given.end() ? std::vector<std::string>() : at->second;
  }

  // From `least` to `most`; `what` says what the number is, with its unit.
  std::optional<double> number(std::string_view name,
                               std::string_view what,
                               double least,
                               double most) const {
    const auto text = option(name);
    if (!text) return {};
    const auto value = number_in(*text);
    if (!value || *value < least || *value > most) {
      std::ostringstream expected;
      expected << name << ' ' << *text << ": expected " << what << ", from " << least << " to " << most;
      throw usage_error(expected.str());
    }
    return value;
  }
  double needed_number(std::string_view name, std::string_view what, double least, double most) const {
    const auto value = number(name, what, least, most);
    if (!value) throw usage_error(std::string(name) + " is missing: " + std::string(what));
    return *value;
  }

  // Looks at the next word that is no option, and at those after it.
  std::optional<std::string> peek() const { return words(*this).next(); }
  std::vector<std::string> words_after_first() const {
    words rest(*this);
    std::vector<std::string> all;
    rest.next();
    while (auto one = rest.next()) all.push_back(*one);
    return all;
  }
  // The next word that is no option.
  std::optional<std::string> next() {
    const auto at =
        std::find_if(left.begin(), left.end(), [](const std::string& w) { return !w.starts_with("-"); });
    if (at == left.end()) return {};
    std::string word = *at;
    left.erase(at);
    return word;
  }
  std::string needed_next(std::string_view what) {
    auto word = next();
    if (!word) throw usage_error(std::string(what) + " is missing");
    return *word;
  }

  void nothing_left() const {
    if (left.empty()) return;
    throw usage_error("`" + left.front() + "`: this command does not know it; see `cca-can help`");
  }

private:
  void add(CLI::App& app, const detail::known_command& command) {
    CLI::App* const sub = app.add_subcommand(std::string(command.name), std::string(command.what));
    sub->allow_extras();
    for (const auto& o : detail::known_options) {
      if (!detail::has_command(o.commands, command.name)) continue;
      const std::string name(o.name);
      if (o.what.starts_with(' ')) sub->add_flag(name, flags[name], std::string(o.what.substr(1)));
      else
        sub->add_option(name, given[name], std::string(o.what))
            ->expected(1)
            ->take_all()
            ->allow_extra_args(false);
    }
  }
  [[noreturn]] static void refuse_command(const std::string& word) {
    std::vector<std::string_view> names;
    for (const auto& each : detail::known_commands) names.push_back(each.name);
    const auto near = cca::detail::nearest_name(word, names);
    throw usage_error("there is no command `" + word + "`" +
                      (near.empty() ? "" : ", did you mean `" + std::string(near) + "`?") +
                      (near.empty() ? "; see" : " See") + " `cca-can help`");
  }

  std::string name_of_command, said;
  bool is_help = false;
  std::map<std::string, std::vector<std::string>> given;
  std::map<std::string, bool> flags;
  std::vector<std::string> left;
};

}  // namespace cca_can
