// EXPECT: robot\.description: `drives` of pendulum has 2 entries, and its body has 1 axis \(swing\): give one for each axis
// A joint without a motor is passive, but it has an entry too: its friction and its spring stand there.
#include "pendulum.hpp"

struct pendulum : described<> {
#if CCA_REJECT
  static constexpr std::array<cca::robots::joint_drive, 2> drives{};
#else
  static constexpr std::array<cca::robots::joint_drive, 1> drives{};
#endif
};

static_assert(cca::robots::check_description<pendulum>());
