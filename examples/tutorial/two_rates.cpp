// Tutorial, step 4: runs a graph with two rates. docs/tutorial/4_two_rates.md
//
//   tutorial_two_rates [FILE]    with the parameters in FILE
#include <cstdio>

#include <cca/config.hpp>

#include "swinging_leg.hpp"

// [program]
int main(int count, char** arguments) {
  cca::controller<swinging_leg> c;
  try {
    if (count > 1) c.load(arguments[1]);
    else c.load();
  } catch (const cca::refused& refusal) {
    std::printf("%s\n", refusal.what());
    return 1;
  }
  c.start();
  for (int i = 1; i <= 4; ++i) {
    c.run(cca::for_<0.5>{});
    const simple_leg& leg = c.get<"leg">();
    std::printf("%.1f s  hip %6.3f rad, knee %6.3f rad\n", 0.5 * i, leg.angles[0], leg.angles[1]);
  }
  c.stop();
}
// [program end]
