// EXPECT: robot\.description: the joint `swing` of pendulum has a motor and is not measured
// A joint without a port gets no commands.
#include "pendulum.hpp"

struct pendulum : described<> {
  static constexpr std::array drives{cca::robots::joint_drive{
#if CCA_REJECT
      .motor = {5, 20},
#endif
      .spring = 3,
      .measured = false}};
};

static_assert(cca::robots::check_description<pendulum>());
