// EXPECT: space\.mismatch: this space lacks an axis of the body; it must have all axes of the body
// The body has two joints, and its pose and its gravity torques need the angle of each.
#include <cca/robot/body_components.hpp>

struct shoulder : cca::dimension<"shoulder"> {
  static constexpr auto limits = cca::limits{cca::angle{-2, 2}, cca::torque{-9, 9}};
};
struct elbow : cca::dimension<"elbow"> {
  static constexpr auto limits = cca::limits{cca::angle{-2, 2}, cca::torque{-9, 9}};
};
struct mount : cca::frame<"mount"> {};
struct hand : cca::frame<"hand"> {};
struct chain : cca::serial_chain<mount, hand, cca::axes<shoulder, elbow>> {
  static constexpr std::array joints{cca::revolute(cca::along_y),
                                     cca::revolute(cca::along_y, cca::at(0.3, 0, 0))};
  static constexpr auto tip = cca::at(0.3, 0, 0);
  static constexpr std::array links{cca::link_inertia{1, {0.1, 0, 0}, {0.01, 0.01, 0.01, 0, 0, 0}},
                                    cca::link_inertia{1, {0.1, 0, 0}, {0.01, 0.01, 0.01, 0, 0, 0}}};
};
struct arm : cca::body<mount, cca::part<"arm", chain>> {};
struct angles : cca::space<cca::joint_angles, cca::axes<shoulder, elbow>> {};
struct velocities : cca::space<cca::joint_velocities, cca::axes<shoulder, elbow>> {};
struct torques : cca::space<cca::joint_torques, cca::axes<shoulder, elbow>> {};

#if CCA_REJECT
struct measured : cca::space<cca::joint_angles, cca::axes<elbow>> {};
#else
struct measured : cca::space<cca::joint_angles, cca::axes<elbow, shoulder>> {};
#endif

cca::gravity_compensation<arm, measured, torques> gravity;
