// EXPECT: robot\.description: a joint of this robot has a motor and is not measured
// A joint without a port gets no commands.
#include <cca/robots/description.hpp>

struct mount : cca::frame<"mount"> {};
struct hand : cca::frame<"hand"> {};
struct swing : cca::dimension<"swing"> {
  static constexpr auto limits = cca::limits{cca::angle{-3, 3}, cca::velocity{-2, 2}, cca::torque{-9, 9}};
};

struct arm_chain : cca::serial_chain<mount, hand, cca::axes<swing>> {
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0.3, 0, 0);
  static constexpr std::array links{cca::link_inertia{1, {0.1, 0, 0}, {0.01, 0.01, 0.01, 0, 0, 0}}};
};

struct pendulum {
  struct body : cca::body<mount, cca::part<"arm", arm_chain>> {};
  using rate = cca::rate<1000>;
  using commands = cca::robots::commands<cca::robots::torque_command>;
  static constexpr std::array drives{cca::robots::joint_drive{
#if CCA_REJECT
      .motor = {5, 20},
#endif
      .spring = 3,
      .measured = false}};
};

static_assert(cca::robots::check_description<pendulum>());
