#pragma once
// What Python trains with: the graph of the robot with a stand-in for the policy, and beside it a trot, whose
// angles are the lesson. docs/python.md; docs/tutorial/10_policy.md.
#include <cca/mapping/mapping.hpp>
#include <cca/python/score.hpp>
#include <cca/python/stand_in.hpp>
#include <cca/python/task.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "../trot/engines/any.hpp"
#include "../walking_policy/teacher.hpp"
#include "robot.hpp"

namespace pytorch_walk {

// [teacher]
// At the policy's rate.
struct same_angles {
  auto operator()(const auto& q) const { return q.vector(); }
};
struct slow : cca::mapping<oncilla::leg_angles, targets, same_angles> {};

// Sees the lesson, too: Python takes these numbers apart.
struct taught
    : cca::python::stand_in_of<cca::policy_inputs<cca::in<"gait_clock", gait_clock>,
                                                  cca::in<"projected_gravity", gravity>,
                                                  cca::in<"base_ang_vel", oncilla::trunk_angular_velocity>,
                                                  cca::in<"joint_pos", oncilla::leg_angles>,
                                                  cca::in<"lesson", targets>>,
                               targets> {};

// 1 in the step in which it falls, which ends the episode.
struct judge {
  auto process(cca::beat)
      -> std::tuple<cca::out<"reward", cca::python::reward>, cca::out<"done", cca::python::done>> {
    return {along, fallen};
  }
  double along = 0, fallen = 0;  // m, in the last beat; 1: fallen
};

struct school : cca::graph<cca::rate<1000>,
                           cca::node<"gait",
                                     gait_of<taught,
                                             cca::expose<"policy.lesson", "lesson">,
                                             cca::expose<"cpg.phase", "phase">,
                                             cca::expose<"cpg.amplitude", "amplitude">>>,
                           cca::node<"posture", walking::teachers_posture, cca::timed<period>>,
                           cca::node<"trot", walking::teacher, cca::port_triggered<"phase">>,
                           cca::node<"slow", slow, cca::timed<period>>,
                           cca::node<"limits", cca::limiter<oncilla::leg_angles>>,
                           cca::node<"robot", cca::sim::compiled_oncilla>,
                           cca::node<"judge", judge, cca::timed<1>>,
                           cca::node<"score", cca::python::score>,

                           cca::wire<"robot.orientation", "gait.orientation", cca::latest>,
                           cca::wire<"robot.angular_velocity", "gait.rates", cca::latest>,
                           cca::wire<"robot.angles", "gait.angles", cca::latest>,
                           cca::wire<"gait.command", "limits.command">,
                           cca::wire<"robot.angles", "limits.measured">,
                           cca::wire<"limits.safe", "robot.command">,

                           cca::wire<"robot.orientation", "posture.orientation", cca::latest>,
                           cca::wire<"posture.turn", "trot.turn", cca::latest>,
                           cca::wire<"posture.lean", "trot.lean", cca::latest>,
                           cca::wire<"gait.phase", "trot.phase">,
                           cca::wire<"gait.amplitude", "trot.amplitude">,
                           cca::wire<"trot.angles", "slow.input", cca::latest>,
                           cca::wire<"slow.output", "gait.lesson">,
                           cca::wire<"judge.reward", "score.reward">,
                           cca::wire<"judge.done", "score.done">> {};

struct lessons : cca::python::task<school, "gait.policy", "score"> {
  static void begin(controller& c, std::uint64_t seed) {
    const auto drawn = cca::sim::disturbance::from_seed(seed, seconds);
    c.get<"robot.simulator">().put_down(
        cca::sim::compiled_oncilla_world(cca::sim::terrain::flat().with_friction(drawn.friction),
                                         trot::put_down(walking::teacher().p, drawn)),
        drawn);
  }
  static void before_beat(controller& c) {
    const auto& world = c.get<"robot.simulator">().world();
    c.get<"judge">().along = 0.001 * world.trunk_velocity()[0];
    c.get<"judge">().fallen = world.fallen();
  }
};
// [teacher end]

}  // namespace pytorch_walk
