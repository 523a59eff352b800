#pragma once
// How the environments of this process kept up with the clock, as text: for people, and for the process that
// has started this one. Over DDS a process knows only its own.
#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <cca/runtime/environments/figures.hpp>

namespace deployed {

inline double wake_p99_us(const cca::environment_figures& one) {
  return 1e-3 * static_cast<double>(one.wake_up.quantile(0.99));
}

// The table of these figures. Empty without a clock.
inline std::string table_of(std::vector<cca::environment_figures> all) {
  std::erase_if(all, [](const auto& one) { return one.beat.count() == 0; });
  if (all.empty()) return {};
  std::ostringstream text;
  text << all;
  return text.str();
}

// The table of one environment, and a line for programs: `robot: wake-up p99 12.5 us`.
inline std::string told_of(const std::vector<cca::environment_figures>& all, std::string_view environment) {
  std::ostringstream text;
  for (const auto& one : all)
    if (one.name == environment && one.beat.count() > 0)
      text << table_of({one}) << one.name << ": wake-up p99 " << wake_p99_us(one) << " us\n";
  return text.str();
}

// In what such a process has printed: the row of an environment in the table, and its wake-up.
struct told_figures {
  std::string row;
  std::optional<double> wake_p99_us;
};
inline told_figures figures_in(const std::string& printed, const std::string& environment) {
  told_figures found;
  const std::string wake_up = environment + ": wake-up p99 ";
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(wake_up)) found.wake_p99_us = std::stod(line.substr(wake_up.size()));
    else if (line.starts_with(environment + " ")) found.row = line + '\n';
  return found;
}

}  // namespace deployed
