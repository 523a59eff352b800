// A component that computes for 8 ms in an architecture whose beats last 1 ms. In one loop it would stop the
// robot for 8 of 10 beats. In an environment of its own it stops nothing, and computes the same. --help lists
// the options. docs/environments.md
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <cca/config.hpp>
#include <cca/main.hpp>

#if __has_include(<cca/record.hpp>)
#include <cca/record.hpp>  // offers --record
#endif
#if __has_include(<cca/door.hpp>)
#include <cca/door.hpp>  // offers --door
#endif

#include "thoughtful_leg.hpp"

namespace {

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

struct program : cca::robot_program<split> {
  program() {
    purpose = "a component that computes for 8 ms beside a leg with beats of 1 ms";
    settings.seconds = 0.3;
  }

  void options(cca::command_line& line) override {
    line.number("--seconds S", settings.seconds, 0.01, 10, "how long, in virtual time (0.3)");
  }

  // The leg runs in the first environment, so `between` may look at it at any pace.
  bool between(controller_type& c) override {
    if (runs("robot")) timely.push_back(c.get<"leg">().angle);
    return true;
  }

  int finish(controller_type& live) override { return runs("robot") ? compare(live) : 0; }

  // The angle of the leg after each of as many beats.
  template <class Controller, class Pace>
  std::vector<double> play(Controller& c, Pace pace) const {
    std::vector<double> angles;
    angles.reserve(timely.size());
    if (settings.configs.empty()) c.load();
    for (const auto& file : settings.configs) c.load(file);
    c.start();
    c.run(cca::for_some_beats{static_cast<std::int64_t>(timely.size())}, pace,
          [&](auto& running) { angles.push_back(running.template get<"leg">().angle); });
    return angles;
  }

  int compare(const controller_type& live) const {
    // [program]
    cca::controller<thoughtful_leg> one_loop;
    const auto expected = play(one_loop, cca::at_wall_clock());  // 8 beats of 10 are lost

    cca::deployed<split> fast;
    const auto exact = play(fast, cca::as_fast_as_possible{});
    // [program end]

    tell("one loop, wall-clock run:", expected.size(), expected.size(), 0, one_loop.overruns(),
         one_loop.lost_periods());
    tell("deployed, fast run:", count_equal(expected, exact), exact.size(), fast.late(), fast.overruns(),
         fast.lost_periods());
    tell(settings.speed == 1 ? "deployed, wall-clock run:" : "deployed, at the pace given:",
         count_equal(expected, timely), timely.size(), live.late(), live.overruns(), live.lost_periods());

    // In a fast run nothing can be late. In a wall-clock run that depends on the machine; but if
    // nothing was, the results are the same.
    const bool was_in_time = live.late() == 0 && live.lost_periods() == 0 && !live.fault();
    return exact == expected && (!was_in_time || timely == expected) ? 0 : 1;
  }

  std::vector<double> timely;
};

}  // namespace

int main(int count, char** words) { return cca::robot_main<program>(count, words); }
