// Finds out when the policy of a task fires: a copy of its controller runs until it has fired three times.
//
// Errors: cca::refused, if it does not fire in the first minute, or not evenly.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <cca/python/episode.hpp>

namespace cca::python {

template <class Task>
firing_times found_firings(const typename Task::controller& loaded) {
  auto c = loaded;
  Task::begin(c, 0);
  c.start();
  std::array<std::int64_t, 3> at{};
  std::size_t found = 0;
  const std::int64_t minute = 60'000'000'000 / Task::controller::period();
  for (std::int64_t k = 0; k < minute && found < at.size(); ++k) {
    const bool goes_on = episode<Task>::run_beat(c);
    if (Task::policy_of(c).firings > static_cast<std::int64_t>(found)) at[found++] = k;
    if (!goes_on && found < at.size())
      throw refused("the task ends before its policy has fired three times: " + c.fault_path() + ": " +
                    std::string(c.fault().reason()));
  }
  if (found < at.size())
    throw refused(
        "the policy of the task has not fired three times in a minute: give its node cca::timed<N>");
  const firing_times times{at[0], at[1] - at[0]};
  if (at[2] - at[1] != times.period)
    throw refused("the policy of the task does not fire evenly: give its node cca::timed<N>");
  return times;
}

}  // namespace cca::python
