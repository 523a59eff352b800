#pragma once
// The policy: all angles of the legs from what the robot observes at this moment.
#include <limits>

#include <cca/cca.hpp>
#include <cca/mapping/policy.hpp>

#include "spaces.hpp"

namespace walking {

// [policy]
using observations = cca::policy_inputs<cca::in<"clock", stride_clock>,
                                        cca::in<"down", downwards>,
                                        cca::in<"rates", oncilla::trunk_angular_velocity>,
                                        cca::in<"course", course>,
                                        cca::in<"angles", oncilla::leg_angles>>;
inline constexpr int units = 32;  // of each hidden layer

struct policy
    : cca::policy<observations, cca::hidden_layers<units, units>, cca::hyperbolic_tangent, commanded_angles> {
};
// [policy end]

// From its rate to that of the robot. It reaches what the policy wants after 9 beats.
struct smooth : cca::interpolate<commanded_angles, oncilla::leg_angles> {};
// While the policy has not answered yet, the limiter holds the measured angles: NaN is no command.
using before_the_first = cca::initial<std::numeric_limits<double>::quiet_NaN()>;

}  // namespace walking
