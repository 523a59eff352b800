// EXPECT: robot\.compiled: the joint `swing` of pendulum turns nothing that resists it
// A compiled world divides by the inertia that a joint moves. A mass on the axis of the only joint has none
// about it.
#include <cca/sim/compiled/compiled_world.hpp>

#include "pendulum.hpp"

struct on_the_axis : weightless_chain {
#if CCA_REJECT
  static constexpr std::array links{cca::link_inertia { 1, {0, 0, 0}, {} }};
#else
  static constexpr std::array links{cca::link_inertia{1, {0, 0, 0.1}, {}}};
#endif
};
struct pendulum : described<on_the_axis> {};

cca::sim::compiled_world<pendulum> world;
