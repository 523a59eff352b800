#pragma once
// One run of the Combination of Skills in a simulated world, and its result. The robot is the simulator's, or
// one on virtual drives around it (examples/hardware_in_the_loop). `act` takes either as a stage: it has a
// `controller`, loaded and not started, `step()`, `world()`, `put_down(world, disturbance)` and
// `disturb(disturbance)`.
#include <cmath>
#include <utility>

#include <cca/cca.hpp>
#include <cca/sim/disturbance.hpp>
#include <cca/sim/oncilla.hpp>
#include <cca/sim/world.hpp>

#include "architecture.hpp"
#include "../trot/report/goes_on.hpp"
#include "referee.hpp"

namespace skills {

struct simulated : architecture<cca::sim::oncilla> {};
using combined = cca::controller<simulated>;

// The distance between the joints and their commands.
template <class Controller>
double tracking_error(const Controller& controller) {
  double error = std::nan("");
  controller.observed([&](const cca::observation& one) {
    if (one.path == "dmp.criterion.error") error = one.values[0];
  });
  return error;
}

// Calls between(controller) after each beat, and ends if it returns false.
template <class Stage, class Between>
result act(Stage& stage, const circumstances& c, Between between) {
  referee watching(c);
  auto& controller = stage.controller;
  auto& camera = controller.template get<"camera">();
  const auto& sequencer = controller.template get<"sequencer">().steps;
  stage.put_down(watching.put_down(controller.template get<"orders">().p), watching.disturbance());
  controller.start();
  for (bool goes_on = true; goes_on && !watching.is_over();) {
    const auto& world = stage.world();
    const double time = world.time();
    const auto ball = watching.ball(world);
    camera.sees = ball.has_value();
    if (ball) camera.ball = *ball;
    stage.step();
    goes_on = trot::goes_on(between, controller);
    if (watching.note(time, world, sequencer.step(), sequencer.timed_out(),
                      [&] { return tracking_error(controller); }))
      stage.disturb(watching.disturbance());
  }
  return watching.judgement();
}

struct simulated_stage {
  combined& controller;
  const cca::sim::world& world() const { return controller.get<"robot.simulator">().world(); }
  void put_down(cca::sim::world&& w, const cca::sim::disturbance& d) {
    controller.get<"robot.simulator">().put_down(std::move(w), d);
  }
  void disturb(const cca::sim::disturbance& d) { controller.get<"robot.simulator">().disturb(d); }
  void step() { controller.step(); }
};

template <class Between>
result roll_out(combined& controller, const circumstances& c, Between between) {
  simulated_stage stage{controller};
  return act(stage, c, between);
}

}  // namespace skills
