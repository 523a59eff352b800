// EXPECT: space\.bad_axes: the second argument of a space is the list of its axes, and that of a cca::space<joint_angles, \.\.\.> is `tuple<hip, knee>`: write them as in `struct leg_angles : cca::space<
// The list is `cca::axes`, no other one.
#include <tuple>

#include "parts.hpp"

#if CCA_REJECT
struct angles_of_leg : cca::space<cca::joint_angles, std::tuple<hip, knee>> {};
#else
struct angles_of_leg : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
#endif

struct relay {
  auto process(cca::in<"angles", angles_of_leg> a) -> cca::out<"angles", angles_of_leg> { return a.vector(); }
};
