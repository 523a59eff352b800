// EXPECT: robot\.description: `shapes\[0\]` of pendulum is on link 1 of the part `arm`, which has 1, counted from 0
// Links count from 0: the only one of this arm is link 0.
#include "pendulum.hpp"

struct pendulum : described<> {
#if CCA_REJECT
  static constexpr std::array shapes{cca::robots::on_link("arm", 1, cca::robots::sphere(0.05))};
#else
  static constexpr std::array shapes{cca::robots::on_link("arm", 0, cca::robots::sphere(0.05))};
#endif
};

static_assert(cca::robots::check_description<pendulum>());
