// EXPECT: space\.mismatch: `stop\.safe` publishes set_points<joint_list<left_knee>> .* but `stale\.wanted` expects wanted_points
// Before the emergency stop a set point carries the rule that it breaks, after it what the drive may do. A
// guard on the wrong side of it would read one as the other.
#include <cca/cca.hpp>
#include <cca/hardware/joint.hpp>
#include <cca/hardware/mit.hpp>
#include <cca/hardware/safety/emergency_stop.hpp>
#include <cca/hardware/safety/guards.hpp>
#include <cca/hardware/safety/stopping.hpp>

namespace hw = cca::hardware;

struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 2}, cca::velocity{-9, 9}, cca::torque{-8, 8}};
};
struct left_knee
    : hw::joint<knee, hw::mit_drive<hw::ak80_9, 1>, hw::mounting{}, hw::joint_servo{.stiffness = 30}> {};
using joints = hw::joint_list<left_knee>;

struct servos {
  auto act(cca::in<"joints", hw::joint_states<joints>>) -> cca::out<"wanted", hw::wanted_points<joints>> {
    return hw::wanted_points<joints>::vector_type::Zero().eval();
  }
};
struct drives {
  auto sense() -> cca::out<"joints", hw::joint_states<joints>> {
    return hw::joint_states<joints>::vector_type::Zero().eval();
  }
  void act(cca::in<"set_points", hw::set_points<joints>>) {}
};

struct chain : cca::graph<cca::rate<1000>,
                          cca::node<"servos", servos>,
                          cca::node<"stale", hw::stale_guard<joints>>,
                          cca::node<"stop", hw::emergency_stop<joints>>,
                          cca::node<"damping", hw::damping_stop<joints>>,
                          cca::node<"drives", drives>,
                          cca::wire<"drives.joints", "servos.joints">,
                          cca::wire<"drives.joints", "stop.joints">,
                          cca::wire<"drives.joints", "damping.joints">,
#if CCA_REJECT
                          cca::wire<"servos.wanted", "stop.wanted">,
                          cca::wire<"stop.safe", "stale.wanted">,
                          cca::wire<"stale.safe", "damping.wanted">,
#else
                          cca::wire<"servos.wanted", "stale.wanted">,
                          cca::wire<"stale.safe", "stop.wanted">,
                          cca::wire<"stop.safe", "damping.wanted">,
#endif
                          cca::wire<"damping.safe", "drives.set_points">> {
};

cca::controller<chain> controller;
