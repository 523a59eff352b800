// EXPECT: body\.no_inertia: no link of the body robot has a mass, so it has no dynamics, only kinematics
// Kinematics and drives need no inertia, but the torques of gravity do.
#include <cca/robot/body_components.hpp>

struct base : cca::frame<"base"> {};
struct hand : cca::frame<"hand"> {};
struct bend : cca::dimension<"bend"> {};
struct angles : cca::space<cca::joint_angles, cca::axes<bend>> {};
struct torques : cca::space<cca::joint_torques, cca::axes<bend>> {};

struct arm_chain : cca::serial_chain<base, hand, cca::axes<bend>> {
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0.3, 0, 0);
};

#if CCA_REJECT
struct robot : cca::body<base, cca::part<"arm", arm_chain>> {};
#else
struct heavy_arm : arm_chain {
  static constexpr std::array links{cca::link_inertia{1, {0.1, 0, 0}, {0.01, 0.01, 0.01, 0, 0, 0}}};
};
struct robot : cca::body<base, cca::part<"arm", heavy_arm>> {};
#endif

auto hold(cca::in<"angles", angles> now) {
  return cca::gravity_compensation<robot, angles, torques>().process(now, {});
}
