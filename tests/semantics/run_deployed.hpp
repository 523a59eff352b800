// Runs an architecture that is spread over environments, in pieces of different lengths.
#pragma once

#include <algorithm>
#include <memory>
#include <type_traits>

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

// With `Architecture`: restarted it is compared with the controller too.
template <class Deployment, class Architecture = void>
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
  return o;
}

}  // namespace semantics
