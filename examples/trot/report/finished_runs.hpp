#pragma once
// Many independent runs on all cores, with a bar. After ctrl-c those that are over remain.
#include <cstddef>
#include <iostream>
#include <string>

#include <cca/runtime/interruption.hpp>
#include <cca/sim/rollouts.hpp>

#include "progress.hpp"

namespace trot {

// What run(0) to run(count - 1) return, in this order, without those that were interrupted. A run ends early
// once `interrupted`. `program`: the name in the messages.
template <class Run>
auto finished_runs(const std::string& program,
                   std::size_t count,
                   const cca::interruption& interrupted,
                   Run run) {
  progress_bar bar(program);
  auto over = cca::sim::rollouts(
      count, run,
      {.over = [&](std::size_t n) { bar.show(static_cast<double>(n) / static_cast<double>(count)); },
       .stops = [&] { return bool(interrupted); }});
  bar.done();
  if (interrupted) std::cerr << program << ": interrupted after " << over.size() << " runs\n";
  return over;
}

}  // namespace trot
