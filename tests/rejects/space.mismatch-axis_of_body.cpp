// EXPECT: space\.mismatch: measured \(joint_angles over elbow\) lacks the axis shoulder of the body arm; it must have all axes of the body
// The body has two joints, and its pose and its gravity torques need the angle of each.
#include "arm.hpp"

// Refused by a static_assert of the component, without a graph.

struct arm : cca::body<mount, cca::part<"arm", chain>> {};
struct torques : cca::space<cca::joint_torques, cca::axes<shoulder, elbow>> {};

#if CCA_REJECT
struct measured : cca::space<cca::joint_angles, cca::axes<elbow>> {};
#else
struct measured : cca::space<cca::joint_angles, cca::axes<elbow, shoulder>> {};
#endif

cca::gravity_compensation<arm, measured, torques> gravity;
