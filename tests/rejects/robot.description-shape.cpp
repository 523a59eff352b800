// EXPECT: robot\.description: a shape is on a part or on a link that the body doesn't have
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
