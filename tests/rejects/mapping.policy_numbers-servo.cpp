// EXPECT: mapping\.policy_numbers: angles, velocities and torques of a setpoint_servo are over other axes: give them one list of axes
// Below a policy each number of a vector is a joint; a servo does not look for names.
#include <cca/mapping/imported/setpoint_servo.hpp>

struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct angles : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
struct velocities : cca::space<cca::joint_velocities, cca::axes<hip, knee>> {};
struct torques : cca::space<cca::joint_torques, cca::axes<hip, knee>> {};
struct other_torques : cca::space<cca::joint_torques, cca::axes<knee, hip>> {};

#if CCA_REJECT
using wired = other_torques;
#else
using wired = torques;
#endif
using servo = cca::setpoint_servo<angles, velocities, wired>;

servo::parameters as_it_is;
