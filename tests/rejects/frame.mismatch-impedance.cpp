// EXPECT: frame\.mismatch: the principal axes of this Cartesian impedance of the part `[a-z]+` are those of table, but they are those of the base of the body
// Its six stiffnesses are about and along axes that it knows: those of the base, or those of the reference.
#include <cca/robot/compliance/cartesian_impedance.hpp>

#include "arm.hpp"

struct table : cca::frame<"table"> {};

struct arm : cca::body<mount, cca::part<"arm", chain>> {};
struct torques : cca::space<cca::joint_torques, cca::axes<shoulder, elbow>> {};

#if CCA_REJECT
using along = table;
#else
using along = hand;
#endif
using impedance = cca::cartesian_impedance<arm, "arm", angles, velocities, torques, along>;

impedance::vector_6 none;
