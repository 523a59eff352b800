// The options that all programs of robots have, and the contradictions among them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <cca/graph/marks/traceable.hpp>
#include <cca/main/command_line.hpp>
#include <cca/main/descriptions.hpp>
#include <cca/main/robot_program.hpp>
#include <cca/runtime/observers/program_recorder.hpp>
#include <cca/runtime/transports/shared_memory.hpp>

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

template <class D>
std::vector<std::string> names_of_environments() {
  std::vector<std::string> all;
  for (std::size_t e = 0; e < array_size(environment_count<D>); ++e)
    all.emplace_back(name_of_environment<D>(e));
  return all;
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

// Those that the program does not have already.
template <class Program>
void offer_standard_options(command_line& line, Program& p) {
  run_settings& s = p.settings;
  if (!line.has("--config"))
    line.texts("--config FILE", s.configs, "parameters; more than one file is read in this order");
  if (!line.has("--seconds"))
    line.number("--seconds S", s.seconds, 0.001, 1e9,
                "how long, in virtual time (" + (s.seconds ? as_typed(*s.seconds) : "until a signal") + ")");
  if (!line.has("--pace")) offer_pace(line, s);
  if constexpr (AnyDeployment<typename Program::architecture>) {
    const auto environments = names_of_environments<typename Program::architecture>();
    line.value(
        "--only E,F", [&s, environments](const std::string& text) { take_names(text, environments, s.only); },
        "runs these environments; other processes run the rest (all: " + joined_words(environments, ", ") +
            ")");
    p.template transport<shared_memory>(line, "--shared-memory NAME",
                                        "reaches the others on this machine, by a name as /trot");
  }
  if constexpr (HasRecorder<typename Program::controller_type>) {
    if (!line.has("--record"))
      line.text(
          "--record FILE",
          [&s](const std::string& text) {
            if (text.empty()) throw command_line_error("--record: expected the name of a file");
            s.record = text;
          },
          "records all ports into this MCAP file");
    if (!line.has("--page"))
      line.text(
          "--page FILE",
          [&s](const std::string& text) {
            if (text.empty()) throw command_line_error("--page: expected the name of a file");
            s.page = text;
          },
          "records into this HTML file, which any browser shows");
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
  if constexpr (HasReplay<typename Program::controller_type>)
    if (!line.has("--replay"))
      line.text(
          "--replay FILE",
          [&s](const std::string& text) {
            if (text.empty()) throw command_line_error("--replay: expected the name of a file");
            s.replay = text;
          },
          "plays what this recording says was sensed, and compares what is published");
  if constexpr (Traceable<typename Program::architecture>)
    if (!line.has("--trace"))
      line.text(
          "--trace FILE",
          [&s](const std::string& text) {
            if (text.empty()) throw command_line_error("--trace: expected the name of a file");
            s.trace = text;
          },
          "writes when each component fires, for ui.perfetto.dev, and prints a summary");
  if (!line.has("--write-parameters"))
    offer_descriptions<typename Program::controller_type>(line, [&p](typename Program::controller_type& c) {
      p.prepare(c);
      for (const std::string& file : p.settings.configs) read_parameters(c, file);
    });
  if (!line.has("--commands"))
    line.flag("--commands", s.commands,
              "reads p (pause), g (go on), s (one beat) and a speed, each a line, from any input, not only a "
              "terminal");
  if (!line.has("--quiet")) line.flag("--quiet", s.quiet, "prints no figures");
}

template <class Program>
void refuse_contradictions(const command_line& line, const Program& p) {
  if (p.settings.record.empty() && p.settings.page.empty() && !p.settings.record_scopes.empty())
    throw command_line_error("--record-only: say by --record or --page into which file");
  if (!p.settings.replay.empty() &&
      !(p.settings.record.empty() && p.settings.page.empty() && p.settings.trace.empty()))
    throw command_line_error("--replay: nothing is recorded or traced meanwhile");
  if constexpr (AnyDeployment<typename Program::architecture>) {
    const auto environments = names_of_environments<typename Program::architecture>();
    const auto& only = p.settings.only;
    if (p.others.open && only.empty())
      throw command_line_error(p.others.chosen + ": say by --only which environments this process runs: " +
                               joined_words(environments, ", "));
    if (!only.empty() && !p.others.open)
      throw command_line_error(
          "--only " + joined_words(only, ",") +
          ": say how it reaches the other environments: " + joined_words(p.others.offered, " or "));
    if (line.is_given("--pace") && !p.runs(environments.front()))
      throw command_line_error("--pace: `" + environments.front() +
                               "` gives the beat: say it to the process that runs it");
  }
}

}  // namespace cca::detail
