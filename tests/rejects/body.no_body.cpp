// EXPECT: body\.no_body: the body of a robot is wanted, and `arm` is the description of one: write `arm::body`
// LINES: 15
// Kinematics and dynamics are those of a body. The description of a robot has one, beside its rate, its
// drives and its commands.
#include <cca/cca.hpp>

#include "arm.hpp"

struct arm_body : cca::body<mount, cca::part<"arm", chain>> {};
struct arm {
  using body = arm_body;
  using rate = cca::rate<1000>;
};

#if CCA_REJECT
auto hand_of(const cca::body_pose<arm>& now) { return now.tip<"arm">(); }
#else
auto hand_of(const cca::body_pose<arm::body>& now) { return now.tip<"arm">(); }
#endif
