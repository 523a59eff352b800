// EXPECT: robot\.description: a joint of this robot is in two groups with the same kind of command
// `bend` would have two torques.
#include <cca/robots/description.hpp>

struct mount : cca::frame<"mount"> {};
struct hand : cca::frame<"hand"> {};
template <cca::fixed_string Name>
struct joint : cca::dimension<Name> {
  static constexpr auto limits = cca::limits{cca::angle{-3, 3}, cca::velocity{-2, 2}, cca::torque{-9, 9}};
};
struct swing : joint<"swing"> {};
struct bend : joint<"bend"> {};
struct wave : joint<"wave"> {};

struct arm_chain : cca::serial_chain<mount, hand, cca::axes<swing, bend>> {
  static constexpr std::array joints{cca::revolute(cca::along_y),
                                     cca::revolute(cca::along_y, cca::at(0.3, 0, 0))};
  static constexpr auto tip = cca::at(0.3, 0, 0);
  static constexpr cca::link_inertia link{1, {0.1, 0, 0}, {0.01, 0.01, 0.01, 0, 0, 0}};
  static constexpr std::array links{link, link};
};

template <class... Axes>
struct torques_of : cca::space<cca::joint_torques, cca::axes<Axes...>, cca::rate<1000>> {};

struct arm {
  struct body : cca::body<mount, cca::part<"arm", arm_chain>> {};
  using inner = cca::robots::of_joints<"inner", cca::robots::torque_command, torques_of<swing>>;
#if CCA_REJECT
  using outer = cca::robots::of_joints<"outer", cca::robots::torque_command, torques_of<bend, swing>>;
#else
  using outer = cca::robots::of_joints<"outer", cca::robots::torque_command, torques_of<bend>>;
#endif
  using commands = cca::robots::commands<inner, outer>;
  using rate = cca::rate<1000>;
  static constexpr std::array<cca::robots::joint_drive, 2> drives{};
};

static_assert(cca::robots::check_description<arm>());
