// Compares what the leg did in a deployment with what it does in one loop.
#pragma once

#include <cstdint>
#include <cstdio>
#include <vector>

#include "thoughtful_leg.hpp"

// `angles` are those of the leg after each beat. Prints the result and returns the exit code. In a wall-clock
// run samples may be late; then the leg is another one.
inline int compare_with_one_loop(const std::vector<double>& angles, const cca::deployed<split>& d) {
  std::vector<double> expected;
  cca::controller<thoughtful_leg> one_loop;
  one_loop.load();
  one_loop.start();
  one_loop.run(cca::for_some_beats{static_cast<std::int64_t>(angles.size())}, {},
               [&](auto& running) { expected.push_back(running.template get<"leg">().angle); });
  const bool was_late = d.late() > 0 || d.lost_periods() > 0;
  std::printf("%zu beats, %s\n", angles.size(),
              angles == expected ? "bit for bit as in one loop"
              : was_late         ? "and some samples were late"
                                 : "NOT as in one loop");
  return angles == expected || was_late ? 0 : 1;
}
