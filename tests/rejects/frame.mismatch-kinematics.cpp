// EXPECT: frame\.mismatch: kinematics say where the tip of a chain is in the frame of its base, trunk, but paw_place \(cartesian_position<world> over x, z\) has another frame
// The chain begins in the trunk, but the paw is wanted in the world.
#include <cca/mapping/inverse_kinematics.hpp>

#include "parts.hpp"

struct paw : cca::frame<"paw"> {};

struct leg_chain : cca::serial_chain<trunk, paw, cca::axes<hip, knee>> {
  static constexpr std::array joints{cca::revolute(cca::along_y),
                                     cca::revolute(cca::along_y, cca::at(0, 0, -0.1))};
  static constexpr auto tip = cca::at(0, 0, -0.1);
};

#if CCA_REJECT
struct paw_place : cca::space<cca::cartesian_position<world>, cca::axes<cca::x, cca::z>> {};
#else
struct paw_place : cca::space<cca::cartesian_position<trunk>, cca::axes<cca::x, cca::z>> {};
#endif

struct ball {
  auto process(cca::beat) -> cca::out<"place", paw_place> { return {}; }
};
struct reach : cca::graph<cca::rate<1000>,
                          cca::node<"log", logbook>,
                          cca::node<"ball", ball>,
                          cca::node<"ik", cca::inverse_kinematics<leg_chain, leg_angles, paw_place>>,
                          cca::wire<"ball.place", "ik.position">> {};

cca::controller<reach> c;
