// The options that all programs of robots have, and the contradictions among them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <cca/base/separate/compiled.hpp>
#include <cca/graph/marks/traceable.hpp>
#include <cca/main/command_line.hpp>
#include <cca/main/descriptions.hpp>
#include <cca/runtime/observers/program_door.hpp>
#include <cca/main/robot_program.hpp>
#include <cca/main/run_settings.hpp>
#include <cca/runtime/observers/program_recorder.hpp>
#include <cca/runtime/transports/shared_memory.hpp>

namespace cca::detail {

template <class D>
std::vector<std::string> names_of_environments() {
  std::vector<std::string> all;
  for (std::size_t e = 0; e < array_size(environment_count<D>); ++e)
    all.emplace_back(name_of_environment<D>(e));
  return all;
}

// In the order of --help; each only if the program does not have it already.
void offer_length_and_pace(command_line& line, run_settings& s);
void offer_environments(command_line& line, run_settings& s, const std::vector<std::string>& existing);
void offer_recording(command_line& line, run_settings& s);
void offer_replay(command_line& line, run_settings& s);
void offer_trace(command_line& line, run_settings& s);
void offer_commands(command_line& line, run_settings& s);
void offer_door(command_line& line, run_settings& s);

template <class Program>
void offer_standard_options(command_line& line, Program& p) {
  run_settings& s = p.settings;
  offer_length_and_pace(line, s);
  if constexpr (AnyDeployment<typename Program::architecture>) {
    offer_environments(line, s, names_of_environments<typename Program::architecture>());
    p.template transport<shared_memory>(line, "--shared-memory NAME",
                                        "reaches the others on this machine, by a name as /trot");
  }
  if constexpr (HasRecorder<typename Program::controller_type>) offer_recording(line, s);
  if constexpr (HasReplay<typename Program::controller_type>) offer_replay(line, s);
  if constexpr (Traceable<typename Program::architecture>) offer_trace(line, s);
  if (!line.has("--write-parameters"))
    offer_descriptions<typename Program::controller_type>(line, [&p](typename Program::controller_type& c) {
      p.prepare(c);
      for (const std::string& file : p.settings.configs) read_parameters(c, file);
    });
  offer_commands(line, s);
  if constexpr (HasDoor<typename Program::controller_type>) offer_door(line, s);
}

// How this process reaches the other environments: the options for it, and the one that was taken.
struct ways_to_others {
  const std::vector<std::string>& offered;
  const std::string& chosen;
  bool is_open;
};
void refuse_contradictions(const run_settings& s);
void refuse_contradictions(const command_line& line,
                           const run_settings& s,
                           const std::vector<std::string>& environments,
                           const ways_to_others& others);

template <class Program>
void refuse_contradictions(const command_line& line, const Program& p) {
  if constexpr (AnyDeployment<typename Program::architecture>)
    refuse_contradictions(line, p.settings, names_of_environments<typename Program::architecture>(),
                          {p.others.offered, p.others.chosen, static_cast<bool>(p.others.open)});
}

}  // namespace cca::detail

#if !CCA_HAS_COMPILED_MAIN
#include <cca/main/standard_options_functions.hpp>
#endif
