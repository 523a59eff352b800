// The standard options that depend on no program's type. standard_options.hpp includes this, unless they are
// compiled once for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <cca/main/standard_options.hpp>

namespace cca::detail {

inline std::string joined_words(const std::vector<std::string>& all, std::string_view between) {
  std::string text;
  for (const auto& each : all) text.append(text.empty() ? "" : between).append(each);
  return text;
}

inline std::string as_typed(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

inline void offer_pace(command_line& line, run_settings& s) {
  const std::string present = !s.speed ? "fast" : *s.speed == 1 ? "wall-clock" : as_typed(*s.speed);
  line.value(
      "--pace P",
      [&s](const std::string& text) {
        if (text == "fast") s.speed.reset();
        else if (text == "wall-clock") s.speed = 1;
        else try {
            s.speed = number_in("--pace", text, 1e-3, 1e3);
          } catch (const command_line_error&) {
            throw command_line_error("--pace " + text +
                                     ": expected fast, wall-clock or a factor from 0.001 to "
                                     "1000: 0.5 is half as fast as the clock");
          }
      },
      "fast, wall-clock, or a factor: 0.5 is half as fast (" + present + ")");
}

inline std::vector<std::string> split_words(const std::string& text) {
  std::vector<std::string> all;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    all.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return all;
}

inline void take_names(const std::string& text,
                       const std::vector<std::string>& existing,
                       std::vector<std::string>& into) {
  for (const std::string& name : split_words(text)) {
    if (std::ranges::find(existing, name) == existing.end())
      throw command_line_error("--only " + text + ": there is no environment `" + name + "`, only " +
                               joined_words(existing, ", "));
    into.push_back(name);
  }
}

CCA_MAIN_INLINE void offer_length_and_pace(command_line& line, run_settings& s) {
  if (!line.has("--config"))
    line.texts("--config FILE", s.configs, "parameters; more than one file is read in this order");
  if (!line.has("--seconds"))
    line.number("--seconds S", s.seconds, 0.001, 1e9,
                "how long, in virtual time (" + (s.seconds ? as_typed(*s.seconds) : "until a signal") + ")");
  if (!line.has("--pace")) offer_pace(line, s);
}

CCA_MAIN_INLINE void offer_environments(command_line& line,
                                        run_settings& s,
                                        const std::vector<std::string>& existing) {
  line.value(
      "--only E,F", [&s, existing](const std::string& text) { take_names(text, existing, s.only); },
      "runs these environments; other processes run the rest (all: " + joined_words(existing, ", ") + ")");
}

// `option`: its name, without a value.
inline void offer_file(command_line& line,
                       const std::string& option,
                       std::string& into,
                       std::string_view help) {
  if (line.has(option)) return;
  line.text(
      option + " FILE",
      [&into, option](const std::string& text) {
        if (text.empty()) throw command_line_error(option + ": expected the name of a file");
        into = text;
      },
      help);
}

CCA_MAIN_INLINE void offer_recording(command_line& line, run_settings& s) {
  offer_file(line, "--record", s.record, "records all ports into this MCAP file");
  offer_file(line, "--page", s.page, "records into this HTML file, which any browser shows");
  if (!line.has("--record-only"))
    line.text(
        "--record-only S,T",
        [&s](const std::string& text) {
          s.record_scopes = split_words(text);
          if (std::ranges::find(s.record_scopes, "") != s.record_scopes.end())
            throw command_line_error("--record-only " + text + ": expected scopes, as dmp,limits.safe");
        },
        "records only the ports under these scopes, as dmp or dmp.phase");
}

inline constexpr std::string_view nothing_is_written = "a replay neither records nor traces";

// Why a replay does not use an option; empty: the option keeps its promise. What a program offers itself is
// for its own functions.
inline std::string why_not_in_replay(std::string_view option) {
  if (option == "--quiet") return {};  // a replay prints no figures
  if (option == "--config") return "a replay takes the parameters from the recording";
  if (option == "--seconds") return "a replay is as long as the recording";
  if (option == "--pace" || option == "--commands" || option == "--paused" || option.starts_with("--door") ||
      option == "--twin" || option == "--on-lost" || option == "--on-fault")
    return "a replay is always a fast run without a pause";
  if (option == "--only" || option == "--shared-memory")
    return "a replay computes all environments in one loop";
  if (option == "--list" || option == "--write-parameters") return "take one of them";
  for (const std::string_view file : {"--record", "--record-only", "--page", "--trace"})
    if (option == file) return std::string(nothing_is_written);
  return "a replay does not use it: it takes all from the recording, and calls no function of the program";
}

CCA_MAIN_INLINE void offer_replay(command_line& line, run_settings& s) {
  if (line.has("--replay")) return;
  offer_file(line, "--replay", s.replay,
             "plays what this recording says was sensed, and compares what is published");
  line.refuses("--replay", why_not_in_replay);
}

CCA_MAIN_INLINE void offer_trace(command_line& line, run_settings& s) {
  offer_file(line, "--trace", s.trace,
             "writes when each component fires, for ui.perfetto.dev, and prints a summary");
}

CCA_MAIN_INLINE void offer_commands(command_line& line, run_settings& s) {
  if (!line.has("--commands"))
    line.flag("--commands", s.commands,
              "reads p (pause), g (go on), s (one beat) and a speed, each a line, from any input, not only a "
              "terminal");
  if (!line.has("--paused"))
    line.flag("--paused", s.paused, "waits before its first beat until it is told to go on");
  if (!line.has("--on-fault"))
    line.text(
        "--on-fault WHAT",
        [&s](const std::string& text) {
          if (text != "end" && text != "hold")
            throw command_line_error("--on-fault " + text + ": expected end or hold");
          s.on_fault = text;
        },
        "what the program does at a fault: end, or hold until it is told to resume or to start anew (" +
            s.on_fault + ")");
  if (!line.has("--quiet")) line.flag("--quiet", s.quiet, "prints no figures");
}

CCA_MAIN_INLINE void offer_door(command_line& line, run_settings& s) {
  if (line.has("--door")) return;
  line.value(
      "--door [PORT]",
      [&line, &s](const std::string& text) {
        s.door = static_cast<std::uint16_t>(text.empty() ? 8765 : whole_number_in("--door", text, 0, 65535));
        if (!line.is_given("--pace") && !s.speed) s.speed = 1;  // a fast run is over before anybody looks
      },
      "lets viewers and cca-top connect while it runs, in a wall-clock run (port 8765; 0: any)");
  line.text("--door-address A", s.door_address, "listens there, not only to this machine");
  line.texts("--door-origin URL", s.door_origins,
             "lets a viewer connect that is a page of that address, such as https://app.foxglove.dev");
  offer_file(line, "--door-token", s.door_token,
             "what a client must know to change anything (made anew for each run)");
  offer_file(line, "--twin", s.twin,
             "the controller as WebAssembly, which the page of the door runs beside this one");
  line.text(
      "--on-lost WHAT",
      [&s](const std::string& text) {
        if (text != "stop" && text != "hold" && text != "go-on")
          throw command_line_error("--on-lost " + text + ": expected stop, hold or go-on");
        s.on_lost = text;
      },
      "what the run does when the client that commands is gone: stop, hold or go-on (go-on)");
}

CCA_MAIN_INLINE void refuse_contradictions(const run_settings& s) {
  if (!s.door && !(s.door_address.empty() && s.door_origins.empty() && s.door_token.empty() &&
                   s.twin.empty() && s.on_lost == run_settings().on_lost))
    throw command_line_error(
        "--door-address, --door-origin, --door-token, --twin and --on-lost: open a door, by --door");
  if (s.record.empty() && s.page.empty() && !s.record_scopes.empty())
    throw command_line_error("--record-only: say by --record or --page into which file");
  if (!s.replay.empty() && !(s.record.empty() && s.page.empty() && s.trace.empty()))
    throw command_line_error("--replay: " + std::string(nothing_is_written));
}

CCA_MAIN_INLINE void refuse_contradictions(const command_line& line,
                                           const run_settings& s,
                                           const std::vector<std::string>& environments,
                                           const ways_to_others& others) {
  if (others.is_open && s.only.empty())
    throw command_line_error(others.chosen + ": say by --only which environments this process runs: " +
                             joined_words(environments, ", "));
  if (!s.only.empty() && !others.is_open)
    throw command_line_error(
        "--only " + joined_words(s.only, ",") +
        ": say how it reaches the other environments: " + joined_words(others.offered, " or "));
  if (others.is_open && s.on_fault == "hold")
    throw command_line_error("--on-fault hold: a fault of several processes ends them all: start them again");
  const bool runs_first = s.only.empty() || std::ranges::find(s.only, environments.front()) != s.only.end();
  if (line.is_given("--pace") && !runs_first)
    throw command_line_error("--pace: `" + environments.front() +
                             "` gives the beat: say it to the process that runs it");
}

}  // namespace cca::detail
