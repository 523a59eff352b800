// Tutorial, step 4: runs a graph with two rates, by the main function for robots.
// docs/tutorial/4_two_rates.md
//
//   tutorial_two_rates --config FILE    with the parameters in FILE; --help lists the options
#include <cstdio>

#include <cca/main.hpp>

#include "swinging_leg.hpp"

// [program]
struct program : cca::robot_program<swinging_leg> {
  program() {
    settings.seconds = 2;
    settings.speed.reset();  // a fast run
  }

  bool between(controller_type& c) override {
    if (c.beat_index() % 500 != 0) return true;
    const simple_leg& leg = c.get<"leg">();
    std::printf("%.1f s  hip %6.3f rad, knee %6.3f rad\n", 1e-3 * static_cast<double>(c.beat_index()),
                leg.angles[0], leg.angles[1]);
    return true;  // false would end the run
  }
};

int main(int count, char** words) { return cca::robot_main<program>(count, words); }
// [program end]
