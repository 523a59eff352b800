#pragma once
// One run of the trot in a simulator, whatever its physics: put the robot down as a disturbance says, then
// step until the time is over or the robot falls. It needs no engine; rollout.hpp has the Open Dynamics
// Engine's robot.
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <cca/cca.hpp>
#include <cca/sim/oncilla/disturbance.hpp>
#include <cca/sim/engine/terrain.hpp>
#include <cca/sim/robot/model/robot_world_settings.hpp>
#include <cca/sim/rollouts/in_steps.hpp>

#include "../architecture.hpp"
#include "../report/goes_on.hpp"
#include "../report/recording.hpp"

namespace trot {

// The world in which the robot of a controller is: cca::sim::world, or that of another engine.
template <class Controller>
using world_of =
    std::remove_cvref_t<decltype(std::declval<Controller&>().template get<"robot.simulator">().world())>;

// The posture around which the gait swings, with the noise of the disturbance.
inline cca::sim::initial_posture put_down(const gait::parameters& p, const cca::sim::disturbance& d) {
  cca::sim::initial_posture posture;
  for (std::size_t leg = 0; leg < oncilla::leg_count; ++leg) {
    const leg_shape& shape = oncilla::is_front(leg) ? p.front : p.hind;
    posture.legs[leg] = {shape.hip + d.hip_offset[leg], shape.knee + d.knee_offset[leg], 0};
  }
  posture.trunk_velocity = d.trunk_velocity;
  return posture;
}

template <class Controller>
std::size_t beats_in(double seconds) {
  return static_cast<std::size_t>(std::llround(seconds * 1e9 / static_cast<double>(Controller::period())));
}

// Puts the robot down where a gait stands, for a run of this time, and begins to record it. The controller
// must be loaded and not started.
template <class Controller>  // of any architecture with this robot
recording begin(Controller& controller,
                const gait::parameters& stands,
                const cca::sim::terrain& ground,
                const cca::sim::disturbance& disturbance,
                double seconds,
                const cca::sim::robot_world_settings& physics = {}) {
  // The robot's posture, the ground and the disturbance: [put down]
  auto& simulator = controller.template get<"robot.simulator">();
  world_of<Controller> world(ground.with_friction(disturbance.friction), put_down(stands, disturbance),
                             physics);
  simulator.put_down(std::move(world), disturbance);
  // [put down end]
  recording run;
  run.begin(simulator.world(), beats_in<Controller>(seconds));
  return run;
}

// The trot, where its own gait stands.
template <class Controller>  // of architecture.hpp, or of a graph derived from it
recording begin(Controller& controller,
                const cca::sim::terrain& ground,
                const cca::sim::disturbance& disturbance,
                double seconds,
                const cca::sim::robot_world_settings& physics = {}) {
  return begin(controller, controller.template get<"gait">().p, ground, disturbance, seconds, physics);
}

// A run beat by beat (cca/sim/rollouts/in_steps.hpp): it starts the controller and steps without a clock
// until the time is over, the robot falls, or between(world, part of the run), called after each beat,
// returns false.
template <class Controller, class Between>
class run_in_steps {
public:
  // The controller has begun and stays where it is.
  run_in_steps(Controller& controller, recording run, double seconds, Between between)
      : controller_(&controller),
        run_(std::move(run)),
        beats_(beats_in<Controller>(seconds)),
        between_(std::move(between)) {}

  bool step() {
    if (over_ == 0) controller_->start();
    else if (!notes_last_beat()) return false;
    if (over_ == beats_ || run_.fell) return false;
    ++over_;
    return controller_->step();
  }
  auto& world() { return controller_->template get<"robot.simulator">().world(); }
  recording result() { return std::move(run_); }

private:
  // A fault of the physics ends a run a beat later, so its beat is noted, too.
  bool notes_last_beat() {
    run_.note(world());
    return goes_on(between_, std::as_const(*this).world(),
                   static_cast<double>(over_) / static_cast<double>(beats_)) &&
           !world().trouble();
  }
  const auto& world() const { return controller_->template get<"robot.simulator">().world(); }

  Controller* controller_;
  recording run_;
  std::size_t beats_, over_ = 0;
  Between between_;
};

template <class Controller, class Between>
recording walked(Controller& controller, recording run, double seconds, Between between) {
  run_in_steps steps(controller, std::move(run), seconds, std::move(between));
  return cca::sim::made(steps);
}

// A whole run of the trot.
template <class Controller, class Between>
recording roll_out(Controller& controller,
                   const cca::sim::terrain& ground,
                   const cca::sim::disturbance& disturbance,
                   double seconds,
                   Between between,
                   const cca::sim::robot_world_settings& physics = {}) {
  return walked(controller, begin(controller, ground, disturbance, seconds, physics), seconds, between);
}

}  // namespace trot
