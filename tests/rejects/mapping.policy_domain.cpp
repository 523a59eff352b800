// EXPECT: mapping\.policy_domain: the policy `walk` observes `gyro` as turning_in<trunk>, and its port is of rates_of_imu \(turning_in<imu> over x, y, z\): wire a space of that domain type and frame
// A policy was trained with numbers in one frame; it also refuses another domain type, as velocities for
// angles.
#include "policy_contract.hpp"

struct rates_of_imu : cca::space<turning_in<imu>, xyz> {};

#if CCA_REJECT
using wired = rates_of_imu;
#else
using wired = rates;
#endif
using walking = cca::imported_policy<walk::contract,
                                     cca::policy_inputs<cca::in<"gyro", wired>, cca::in<"joint_pos", angles>>,
                                     targets>;

walking::parameters as_it_is;
