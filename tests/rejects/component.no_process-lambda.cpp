// EXPECT: component\.no_process: `stance` \(.*lambda.*\) is a lambda, which has no `process` from which its ports could be read: write a struct
// LINES: 15
// A component is a struct, no lambda.
#include "parts.hpp"

#if CCA_REJECT
inline const auto stand = [](cca::beat) -> cca::out<"angles", leg_angles> { return {}; };
using standing = std::remove_const_t<decltype(stand)>;
#else
using standing = stance;
#endif

struct walk : cca::graph<cca::rate<1000>, cca::node<"log", logbook>, cca::node<"stance", standing>> {};

cca::controller<walk> c;
