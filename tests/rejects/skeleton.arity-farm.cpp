// EXPECT: skeleton\.arity: `posture` \(farm<.*>\) cannot be shared out: what comes in, three_angles \(joint_angles over 3 axes\) is no whole number of leg_angles \(joint_angles over 2\)
// Three joints do not divide among workers that take two each.
#include "parts.hpp"

struct ankle : cca::dimension<"ankle"> {};
struct toe : cca::dimension<"toe"> {};
struct three_angles : cca::space<cca::joint_angles, cca::axes<hip, knee, ankle>> {};
struct four_angles : cca::space<cca::joint_angles, cca::axes<hip, knee, ankle, toe>> {};

#if CCA_REJECT
using body_angles = three_angles;
#else
using body_angles = four_angles;
#endif

struct measured {
  auto process(cca::beat) -> cca::out<"angles", body_angles> { return {}; }
};
struct whole {
  void process(cca::in<"angles", body_angles>) {}
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"measured", measured>,
                         cca::node<"posture", cca::farm<posture, body_angles, body_angles>>,
                         cca::node<"whole", whole>,
                         cca::wire<"measured.angles", "posture.input">,
                         cca::wire<"posture.output", "whole.angles">> {};

cca::controller<walk> c;
