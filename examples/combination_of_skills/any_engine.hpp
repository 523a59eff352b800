#pragma once
// One run of the Combination of Skills in a simulated world, whatever its physics, and its result. The robot
// is the simulator's, or one on virtual drives around it (examples/hardware_in_the_loop). A run takes either
// as a stage: it has a `controller`, loaded and not started, `step()`, `world()`, `put_down(world,
// disturbance)` and `disturb(disturbance)`. It needs no engine; rollout.hpp has the Open Dynamics Engine's
// robot.
#include <cmath>
#include <type_traits>
#include <utility>

#include <cca/cca.hpp>
#include <cca/sim/oncilla/disturbance.hpp>

#include "architecture.hpp"
#include "../trot/report/goes_on.hpp"
#include "referee.hpp"

namespace skills {

// The distance between the joints and their commands.
template <class Controller>
double tracking_error(const Controller& controller) {
  double error = std::nan("");
  controller.observed([&](const cca::observation& one) {
    if (one.path == "dmp.criterion.error") error = one.values[0];
  });
  return error;
}

// A run of a controller whose loop belongs to somebody else: `begin` puts the robot down before start(),
// `note` shows each beat to the referee and says whether the run goes on, `end` gives the figures.
class noted_run {
public:
  explicit noted_run(const circumstances& c) : watching(c) {}

  template <class Stage>
  void begin(Stage& stage) {
    using world = std::remove_cvref_t<decltype(stage.world())>;
    stage.put_down(watching.put_down<world>(stage.controller.template get<"orders">().p),
                   watching.disturbance());
    look(stage);
  }

  // After a beat.
  template <class Stage>
  bool note(Stage& stage) {
    const auto& sequencer = stage.controller.template get<"sequencer">().steps;
    if (watching.note(began, stage.world(), sequencer.step(), sequencer.timed_out(),
                      [&] { return tracking_error(stage.controller); }))
      stage.disturb(watching.disturbance());
    if (watching.is_over()) return false;
    look(stage);
    return true;
  }

  result end() const { return watching.judgement(); }

private:
  // What the camera sees in the next beat.
  template <class Stage>
  void look(Stage& stage) {
    auto& camera = stage.controller.template get<"camera">();
    began = stage.world().time();
    const auto ball = watching.ball(stage.world());
    camera.sees = ball.has_value();
    if (ball) camera.ball = *ball;
  }

  referee watching;
  double began = 0;  // s, when the beat began
};

template <class Controller>  // of an architecture with a simulated robot, or of a graph derived from it
struct simulated_stage {
  Controller& controller;
  const auto& world() const { return controller.template get<"robot.simulator">().world(); }
  template <class World>
  void put_down(World&& w, const cca::sim::disturbance& d) {
    controller.template get<"robot.simulator">().put_down(std::move(w), d);
  }
  void disturb(const cca::sim::disturbance& d) { controller.template get<"robot.simulator">().disturb(d); }
  void step() { controller.step(); }
};

// A whole fast run. Calls between(controller) after each beat, and ends if it returns false.
template <class Stage, class Between>
result act(Stage& stage, const circumstances& c, Between between) {
  noted_run run(c);
  run.begin(stage);
  stage.controller.start();
  bool goes_on = true;
  while (goes_on) {
    stage.step();
    const bool wanted = trot::goes_on(between, stage.controller);
    goes_on = run.note(stage) && wanted;
  }
  return run.end();
}

template <class Controller, class Between>
result roll_out(Controller& controller, const circumstances& c, Between between) {
  simulated_stage<Controller> stage{controller};
  return act(stage, c, between);
}

}  // namespace skills
