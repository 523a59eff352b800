// A component that computes for 8 ms in an architecture whose beats last 1 ms. In one loop it would stop the
// robot for 8 beats, every 10; in an environment of its own it does not, and computes the same.
// docs/environments.md
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <vector>

#include "thoughtful_leg.hpp"

// The angle of the leg after each beat. The leg runs in the first environment, so `between` may look at it
// at any pace.
template <class Controller, class Pace>
std::vector<double> play(Controller& c, Pace pace) {
  std::vector<double> angles;
  angles.reserve(300);
  c.load();
  c.start();
  c.run(cca::for_<0.3>{}, pace,
        [&](auto& running) { angles.push_back(running.template get<"leg">().angle); });
  return angles;
}

void tell(const char* what,
          std::size_t equal,
          std::size_t beats,
          long long late,
          long long overruns,
          long long lost) {
  std::printf("%-34s %4zu of %4zu beats equal, %4lld late, %4lld overruns, %4lld lost periods\n", what, equal,
              beats, late, overruns, lost);
}

std::size_t count_equal(const std::vector<double>& one, const std::vector<double>& other) {
  std::size_t equal = 0;
  for (std::size_t k = 0; k < std::min(one.size(), other.size()); ++k) equal += one[k] == other[k];
  return equal;
}

int main() {
  // [program]
  cca::controller<thoughtful_leg> one_loop;
  const auto expected = play(one_loop, cca::at_wall_clock());  // 8 beats of 10 are lost

  cca::deployed<split> fast;
  const auto exact = play(fast, cca::as_fast_as_possible{});

  cca::deployed<split> live;
  const auto timely = play(live, cca::at_wall_clock());
  // [program end]

  tell("one loop, at wall-clock speed:", expected.size(), expected.size(), 0, one_loop.overruns(),
       one_loop.lost_periods());
  tell("deployed, as fast as possible:", count_equal(expected, exact), exact.size(), fast.late(),
       fast.overruns(), fast.lost_periods());
  tell("deployed, at wall-clock speed:", count_equal(expected, timely), timely.size(), live.late(),
       live.overruns(), live.lost_periods());
  std::cout << '\n' << live.figures();
  if (live.fault()) std::printf("the deployed one ended with a fault: %s\n", live.fault().reason());

  // As fast as possible nothing can be late. At wall-clock speed that depends on the machine; but if nothing
  // was, the results are the same.
  const bool was_in_time = live.late() == 0 && live.lost_periods() == 0 && !live.fault();
  return exact == expected && (!was_in_time || timely == expected) ? 0 : 1;
}
