// Runs an architecture that is spread over environments, in pieces of different lengths.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include <cca/deployment.hpp>

#include "run.hpp"

namespace semantics {

// What was recorded, by whichever thread, with a controller or a deployment that runs until f returns false.
template <class Played, class F>
log recorded(Played& played, int chance, F goes_on) {
  log all;
  recording = &all;  // of this thread
  auto random = static_cast<unsigned>(chance);
  while (played.beat_index() < beats) {
    random = random * 1664525u + 1013904223u;
    const auto left = beats - played.beat_index();
    const cca::for_some_beats piece{std::min<std::int64_t>(1 + (random >> 8) % 60, left)};
    if (random >> 20 & 1) played.run(piece, cca::as_fast_as_possible{}, [](auto&) {});  // they meet each beat
    else played.run(piece);
    if (!goes_on(played, random)) break;
  }
  recording = nullptr;
  const log others = recorded_by_threads();
  all.insert(all.end(), others.begin(), others.end());
  return merged(std::move(all));
}

// Stopped and started between some pieces, and resumed after some faults.
template <class Played>
log recorded_with_restarts(int chance) {
  const auto played = std::make_unique<Played>();
  played->load();
  played->start();
  return recorded(*played, chance, [resumes = 0](Played& p, unsigned random) mutable {
    if (p.state() == cca::state::faulted) {
      if (++resumes == 5) return false;
      p.resume();
    } else if (random >> 21 & 1) {
      p.stop();
      p.start();
    }
    return true;
  });
}

// The digests of what each environment recorded in a process of its own. `over(name)`: the transport.
template <class Deployment, class F>
std::vector<std::uint64_t> recorded_in_processes(int chance, F over) {
  static int number = 0;
  const std::string name = "cca_semantics_" + std::to_string(::getpid()) + "_" + std::to_string(number++);
  constexpr int count = cca::detail::environment_count<Deployment>;
  std::vector<std::uint64_t> all;
  int from[count];
  for (int e = 0; e < count; ++e) {
    int ends[2];
    if (::pipe(ends) != 0) return {};
    if (::fork() == 0) {
      const cca::only here{cca::detail::environments_of<Deployment>::all[static_cast<std::size_t>(e)].name};
      const auto d = std::make_unique<cca::deployed<Deployment>>(here, over(name));
      d->load();
      d->start();
      const log own =
          recorded(*d, chance, [](const auto& p, unsigned) { return p.state() != cca::state::faulted; });
      for (const firing& f : own) {
        const std::uint64_t one = digest(f);
        if (::write(ends[1], &one, sizeof one) != sizeof one) ::_exit(1);
      }
      ::_exit(0);
    }
    ::close(ends[1]);
    from[e] = ends[0];
  }
  for (const int end : from) {
    for (std::uint64_t one; ::read(end, &one, sizeof one) == sizeof one;) all.push_back(one);
    ::close(end);
  }
  while (::wait(nullptr) > 0) {}
  std::sort(all.begin(), all.end());
  return all;
}

inline std::vector<std::uint64_t> digests(const log& firings) {
  std::vector<std::uint64_t> all;
  for (const firing& f : firings) all.push_back(digest(f));
  std::sort(all.begin(), all.end());
  return all;
}

// With `Architecture`: restarted it is compared with the controller too. With `InProcesses`: also run by
// processes.
template <class Deployment, class Architecture = void, bool InProcesses = false>
outcome run_deployed(int chance) {
  outcome o;
  o.is_merged = true;
  const auto d = std::make_unique<cca::deployed<Deployment>>();
  d->load();
  d->start();
  o.firings = recorded(*d, chance, [](const auto& p, unsigned) { return p.state() != cca::state::faulted; });
  o.faulted = d->state() == cca::state::faulted;
  if constexpr (!std::is_void_v<Architecture>)
    o.copy_agrees = agree(recorded_with_restarts<cca::controller<Architecture>>(chance), 0,
                          recorded_with_restarts<cca::deployed<Deployment>>(chance));
  if constexpr (InProcesses) {
    o.processes_agree = digests(o.firings) ==
                        recorded_in_processes<Deployment>(
                            chance, [](const std::string& name) { return cca::shared_memory("/" + name); });
  }
  return o;
}

}  // namespace semantics
