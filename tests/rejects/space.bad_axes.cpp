// EXPECT: space\.bad_axes: the second argument of a space is the list of its axes, and that of a cca::space<joint_angles> is missing: write them as in `struct leg_angles : cca::space<
// A space states what its coordinates are along.
#include "parts.hpp"

#if CCA_REJECT
struct knee_angle : cca::space<cca::joint_angles> {};
#else
struct knee_angle : cca::space<cca::joint_angles, cca::axes<knee>> {};
#endif

struct bent {
  auto process(cca::beat) -> cca::out<"angle", knee_angle> { return -0.5; }
};
