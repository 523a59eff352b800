// EXPECT: robot\.drives: the rate of this robot is below 200 Hz or above 4 kHz
// Below, drives would notice too late that nobody commands them; above, no bus carries the frames.
#include <cca/hardware/cia402.hpp>
#include <cca/hardware/memory_bus.hpp>
#include <cca/hardware/robot/robot.hpp>

template <cca::fixed_string Name>
struct joint_axis : cca::dimension<Name> {
  static constexpr auto limits = cca::limits{cca::angle{-2, 2}, cca::velocity{-8, 8}, cca::torque{-3, 3}};
};
struct shoulder : joint_axis<"shoulder"> {};
struct elbow : joint_axis<"elbow"> {};
struct mount : cca::frame<"mount"> {};
struct hand : cca::frame<"hand"> {};
struct chain : cca::serial_chain<mount, hand, cca::axes<shoulder, elbow>> {
  static constexpr std::array joints{cca::revolute(cca::along_y),
                                     cca::revolute(cca::along_y, cca::at(0.3, 0, 0))};
  static constexpr auto tip = cca::at(0.3, 0, 0);
  static constexpr std::array links{cca::link_inertia{1, {0.1, 0, 0}, {0.01, 0.01, 0.01, 0, 0, 0}},
                                    cca::link_inertia{1, {0.1, 0, 0}, {0.01, 0.01, 0.01, 0, 0, 0}}};
};
struct arm_body : cca::body<mount, cca::part<"arm", chain, cca::driven_by<"shoulder", "elbow">>> {};

struct arm {
  using body = arm_body;
#if CCA_REJECT
  using rate = cca::rate<100>;
#else
  using rate = cca::rate<1000>;
#endif
  using commands = cca::robots::commands<cca::robots::torque_command>;
  static constexpr std::array<cca::robots::joint_drive, 2> drives{};
};

struct motor {
  static constexpr std::string_view name = "motor";
  static constexpr double counts = 4096, torque = 0.05;
};
template <class Axis, unsigned Node>
struct driven : cca::hardware::joint<Axis,
                                     cca::hardware::cia402<motor, Node, cca::hardware::cia402_mode::torque>,
                                     cca::hardware::mounting{.gear = 40},
                                     cca::hardware::joint_servo{.stiffness = 20}> {};
struct upper : driven<shoulder, 1> {};
struct lower : driven<elbow, 2> {};
using bus = cca::hardware::memory_bus<3, 16>::end_type;

struct robot : cca::hardware::robot<arm, bus, upper, lower> {};
