#pragma once
// What Python trains: the graph of examples/walking_policy around its policy, with a reward.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

#include <cca/cca.hpp>
#include <cca/python/score.hpp>
#include <cca/python/stand_in.hpp>
#include <cca/python/task.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "../trot/rollout.hpp"
#include "../walking_policy/architecture.hpp"
#include "../walking_policy/teacher.hpp"

namespace training {

// [truth]
// What no sensor of the robot measures, in the last beat: the speed along the way, m/s; that of the feet's
// slip, weighted by load, m/s; whether it has fallen.
struct along : cca::dimension<"along"> {};
struct slip : cca::dimension<"slip"> {};
struct fallen : cca::dimension<"fallen"> {};
struct true_motion : cca::space<cca::number, cca::axes<along, slip, fallen>> {};

struct truth {
  auto process() -> cca::out<"motion", true_motion> { return now; }
  true_motion::vector_type now = true_motion::vector_type::Zero();
  double slipped = 0;  // N m, up to the last beat
};
// [truth end]

// [judge]
// As fast as commanded, straight on, with little slip; a fall ends the episode. At most 1 a second.
struct judge {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::speed, 0, 1>, speed),
                             (cca::quantity<cca::duration, 0, 10>, mean),  // of the speed
                             (double, turn),                               // what a rad and a m/s cost
                             (double, slip));
  };
  parameters p{0.4, 0.3, 1.0, 2.0};

  auto process(cca::in<"motion", true_motion> motion,
               cca::in<"course", walking::course> course,
               cca::beat now)
      -> std::tuple<cca::out<"reward", cca::python::reward>, cca::out<"done", cca::python::done>> {
    speed += std::min(1.0, now.dt() / p.mean) * (motion[along{}] - speed);
    const double missing = std::abs(speed - p.speed) / p.speed;
    const double reward =
        1 - std::min(missing, 2.0) - p.turn * std::abs(course[trot::yaw{}]) - p.slip * motion[slip{}];
    return {now.dt() * reward, motion[fallen{}]};
  }

private:
  double speed = 0;
};
// [judge end]

// [graph]
// The strides of the trot; no odometer, so the throttle is a straight line.
template <class Policy>
using gait_of = walking::gait_of<Policy, trot::stride_oscillator>;

template <class Robot>
struct around_policy : cca::graph<cca::rate<1000>,
                                  cca::node<"gait", gait_of<cca::python::stand_in<walking::policy>>>,
                                  cca::node<"limits", cca::limiter<walking::oncilla::leg_angles>>,
                                  cca::node<"robot", Robot>,
                                  cca::node<"truth", truth>,
                                  cca::node<"judge", judge, cca::timed<1>>,
                                  cca::node<"score", cca::python::score>,

                                  cca::wire<"robot.orientation", "gait.orientation", cca::latest>,
                                  cca::wire<"robot.angular_velocity", "gait.rates", cca::latest>,
                                  cca::wire<"robot.angles", "gait.angles", cca::latest>,
                                  cca::wire<"gait.command", "limits.command">,
                                  cca::wire<"robot.angles", "limits.measured">,
                                  cca::wire<"limits.safe", "robot.command">,

                                  cca::wire<"truth.motion", "judge.motion">,
                                  cca::wire<"gait.course", "judge.course", cca::latest>,
                                  cca::wire<"judge.reward", "score.reward">,
                                  cca::wire<"judge.done", "score.done">> {};
// [graph end]

// [task]
struct walk : cca::python::task<around_policy<cca::sim::compiled_oncilla>, "gait.policy", "score"> {
  // The robot where it stands, with the disturbance of the seed.
  static void begin(controller& c, std::uint64_t seed) {
    const auto drawn = cca::sim::disturbance::from_seed(seed, seconds);
    c.get<"robot.simulator">().put_down(
        cca::sim::compiled_oncilla_world(cca::sim::terrain::flat().with_friction(drawn.friction),
                                         trot::put_down(walking::teacher().p, drawn)),
        drawn);
  }
  static void before_beat(controller& c) {
    const auto& world = c.get<"robot.simulator">().world();
    truth& t = c.get<"truth">();
    double slipped = 0;
    for (std::size_t leg = 0; leg < 4; ++leg) slipped += world.foot(leg).slip;
    const double weight = world.mass() * world.settings().engine.gravity;
    t.now << world.trunk_velocity()[0], (slipped - t.slipped) / (weight * world.beat), world.fallen();
    t.slipped = slipped;
  }
};
// [task end]

}  // namespace training
