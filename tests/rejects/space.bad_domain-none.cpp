// EXPECT: space\.bad_domain: the first argument of a space is a domain type, as cca::joint_angles, and `double` is none; a type of your own is one if it states
// A quantity is no domain type, nor is a number.
#include "parts.hpp"

#if CCA_REJECT
struct knee_angle : cca::space<double, cca::axes<knee>> {};
#else
struct knee_angle : cca::space<cca::joint_angles, cca::axes<knee>> {};
#endif

struct bent {
  auto process(cca::beat) -> cca::out<"angle", knee_angle> { return -0.5; }
};
