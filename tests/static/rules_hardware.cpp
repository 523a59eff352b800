// Rules that a chain of drives can break: the message of each mistake, and that the mended one is sound.
#include <cca/hardware/joint.hpp>
#include <cca/hardware/mit.hpp>
#include <cca/hardware/safety/emergency_stop.hpp>
#include <cca/hardware/safety/guards.hpp>
#include <cca/hardware/safety/stopping.hpp>

#include "rules_parts.hpp"

namespace {

namespace hw = cca::hardware;
using namespace parts;

struct elbow : cca::dimension<"elbow"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 2}, cca::velocity{-9, 9}, cca::torque{-8, 8}};
};
struct left_elbow
    : hw::joint<elbow, hw::mit_drive<hw::ak80_9, 1>, hw::mounting{}, hw::joint_servo{.stiffness = 30}> {};
using joints = hw::joint_list<left_elbow>;

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

// Before the emergency stop a set point carries the rule that it breaks, after it what the drive may do: a
// guard on the wrong side of it would read one as the other.
template <class... Wires>
struct guarded : khz<cca::node<"servos", servos>,
                     cca::node<"stale", hw::stale_guard<joints>>,
                     cca::node<"stop", hw::emergency_stop<joints>>,
                     cca::node<"damping", hw::damping_stop<joints>>,
                     cca::node<"drives", drives>,
                     cca::wire<"drives.joints", "servos.joints">,
                     cca::wire<"drives.joints", "stop.joints">,
                     cca::wire<"drives.joints", "damping.joints">,
                     cca::wire<"damping.safe", "drives.set_points">,
                     Wires...> {};
struct guard_after_stop : guarded<cca::wire<"servos.wanted", "stop.wanted">,
                                  cca::wire<"stop.safe", "stale.wanted">,
                                  cca::wire<"stale.safe", "damping.wanted">> {};
struct guard_before_stop : guarded<cca::wire<"servos.wanted", "stale.wanted">,
                                   cca::wire<"stale.safe", "stop.wanted">,
                                   cca::wire<"stop.safe", "damping.wanted">> {};
static_assert(tells<guard_after_stop, guard_before_stop>(
    {"space.mismatch", "stop.safe -> stale.wanted",
     "`stop.safe` publishes set_points<joint_list<left_elbow>> (drive_record<6> over elbow) but "
     "`stale.wanted` expects wanted_points<joint_list<left_elbow>> (wanted_record<6> over elbow): the "
     "domain types differ; put a mapping between them, or wire another port"}));

}  // namespace
