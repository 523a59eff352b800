// What a run of a robot says, and the files that it refuses. robot_run.hpp includes this, unless they are
// compiled once for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <mutex>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <cca/base/after_run.hpp>
#include <cca/base/refused.hpp>
#include <cca/main/one_file.hpp>
#include <cca/main/robot_run.hpp>

namespace cca::detail {

CCA_MAIN_INLINE void refuse_one_file(const run_settings& s) {
  std::vector<named_file> all{
      {"--record", s.record}, {"--page", s.page}, {"--trace", s.trace}, {"--replay", s.replay}};
  for (const std::string& config : s.configs) all.emplace_back("--config", config);
  if (const std::string twice = complaint_of_one_file(all); !twice.empty()) throw refused(twice);
}

CCA_MAIN_INLINE void refuse_unfinished_recording(const std::string& file) {
  const std::string part = file + ".part";
  if (!std::filesystem::exists(file) && std::filesystem::exists(part))
    throw refused("--replay " + file + ": it isn't there, but a run that did not end has left " + part);
}

CCA_MAIN_INLINE std::string text_of_time(std::int64_t nanoseconds) {
  return formatted("after %.3f s", 1e-9 * static_cast<double>(nanoseconds));
}

CCA_MAIN_INLINE std::string left_behind(const std::string& called,
                                        const run_settings& s,
                                        bool has_others,
                                        const std::string& what) {
  std::string text = "\n" + called +
                     ": ended at once by a second SIGINT, not in order: it did not go on "
                     "with stopping for 2 s. Left behind: " +
                     what;
  for (const std::string* file : {&s.record, &s.page, &s.trace})
    if (!file->empty()) text += "; its file " + file->substr(0, 512) + " was not finished";
  if (has_others) text += "; the other processes lose contact";
  return text + "\n";
}

CCA_MAIN_INLINE void print_figures(const std::vector<environment_figures>& all) {
  std::int64_t beats = 0;
  for (const auto& each : all) beats += each.beat.count();
  if (beats == 0) return;
  std::cout << all;
  for (const auto& each : all) {
    if (each.lost_periods > 0)
      std::cout << each.name << ": " << each.lost_periods << " periods without a beat\n";
    for (const auto& channel : each.channels)
      if (channel.late > 0)
        std::cout << each.name << ": " << channel.late << " beats without a sample from " << channel.from
                  << '\n';
  }
  std::cout.flush();
}

CCA_MAIN_INLINE void tell_as(const std::string& called, const std::string& what) {
  std::cerr << called + ": " + what + '\n';
}

CCA_MAIN_INLINE told_meanwhile::told_meanwhile(std::function<std::string()> look,
                                               std::function<void(const std::string&)> tell)
    : looking([this, look = std::move(look), tell = std::move(tell)](std::stop_token ends) {
        std::unique_lock lock(sleeping);
        for (bool was_there = false; !ends.stop_requested();) {
          woken.wait_for(lock, ends, std::chrono::milliseconds(200), [] { return false; });
          if (ends.stop_requested()) return;
          const std::string found = look();
          if (was_there && !found.empty()) return tell(found);
          was_there = !found.empty();
        }
      }) {}

CCA_MAIN_INLINE std::string told_of_fault(std::int64_t period,
                                          const fault_of_run& fault,
                                          const std::vector<std::string>& waits_for) {
  if (fault.beat < 0) return {};
  std::string others = waits_for.empty() ? "all environments" : "";
  for (std::size_t i = 0; i < waits_for.size(); ++i)
    others += (i == 0 ? "" : i + 1 < waits_for.size() ? ", " : " and ") + waits_for[i];
  return causes_of_run(period).sentences(&fault).front() + "; the run waits until " + others +
         (waits_for.size() == 1 ? " has" : " have") + " ended";
}

}  // namespace cca::detail
