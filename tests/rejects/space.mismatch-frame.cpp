// EXPECT: space\.mismatch: `source\.y` publishes foot \(cartesian_position<hip_frame> over x, z\) but `target\.x` expects expected \(cartesian_position<world> over
// The frame belongs to the domain type: the position of a foot seen from the hip is not its position in the
// world.
#include "parts.hpp"

struct hip_frame : cca::frame<"hip"> {};
struct foot : cca::space<cca::cartesian_position<hip_frame>, cca::axes<cca::x, cca::z>> {};

struct source {
  auto process(cca::beat) -> cca::out<"y", foot> { return {}; }
};
#if CCA_REJECT
struct expected : cca::space<cca::cartesian_position<world>, cca::axes<cca::x, cca::z>> {};
#else
struct expected : cca::space<cca::cartesian_position<hip_frame>, cca::axes<cca::x, cca::z>> {};
#endif
struct target {
  void process(cca::in<"x", expected>) {}
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"source", source>,
                         cca::node<"target", target>,
                         cca::wire<"source.y", "target.x">> {};

cca::controller<walk> c;
