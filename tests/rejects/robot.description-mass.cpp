// EXPECT: robot\.description: a link of this body has no mass, so no torque could move it
// Kinematics need no inertia, but a simulated robot does, except between two hinges that cross.
#include <cca/robots/description.hpp>

struct mount : cca::frame<"mount"> {};
struct hand : cca::frame<"hand"> {};
struct swing : cca::dimension<"swing"> {
  static constexpr auto limits = cca::limits{cca::angle{-3, 3}, cca::velocity{-2, 2}, cca::torque{-9, 9}};
};

struct arm_chain : cca::serial_chain<mount, hand, cca::axes<swing>> {
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0.3, 0, 0);
#if !CCA_REJECT
  static constexpr std::array links{cca::link_inertia{1, {0.1, 0, 0}, {0.01, 0.01, 0.01, 0, 0, 0}}};
#endif
};

struct pendulum {
  struct body : cca::body<mount, cca::part<"arm", arm_chain>> {};
  using rate = cca::rate<1000>;
  using commands = cca::robots::commands<cca::robots::torque_command>;
  static constexpr std::array<cca::robots::joint_drive, 1> drives{};
};

static_assert(cca::robots::check_description<pendulum>());
