// EXPECT: space\.mismatch: the torques of the body arm are torques \(joint_torques over shoulder, elbow, gripper\), but have exactly its axes, shoulder, elbow
// A torque of an axis that the body doesn't have would be nobody's.
#include "arm.hpp"

// Refused by a static_assert of the component, without a graph.

struct arm : cca::body<mount, cca::part<"arm", chain>> {};
struct gripper : cca::dimension<"gripper"> {};
#if CCA_REJECT
struct torques : cca::space<cca::joint_torques, cca::axes<shoulder, elbow, gripper>> {};
#else
struct torques : cca::space<cca::joint_torques, cca::axes<elbow, shoulder>> {};
#endif

cca::gravity_compensation<arm, angles, torques> gravity;
