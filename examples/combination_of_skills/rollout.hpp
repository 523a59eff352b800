#pragma once
// One run of the Combination of Skills in a simulated world, and its result. The robot is the simulator's, or
// one on virtual drives around it (examples/hardware_in_the_loop). A run takes either as a stage: it has a
// `controller`, loaded and not started, `step()`, `world()`, `put_down(world, disturbance)` and
// `disturb(disturbance)`.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <cca/cca.hpp>
#include <cca/sim/disturbance.hpp>
#include <cca/sim/oncilla.hpp>
#include <cca/sim/terrain.hpp>
#include <cca/sim/world.hpp>

#include "architecture.hpp"
#include "../trot/report/goes_on.hpp"
#include "scene.hpp"

namespace skills {

struct simulated : architecture<cca::sim::oncilla> {};
using combined = cca::controller<simulated>;

struct circumstances {
  std::optional<std::uint64_t> seed = 0;  // none: no disturbance
  paw_side paw = paw_side::left;
  target where = target::ahead;
  double push = 20;           // N on the trunk from the side, while the paw is at the ball
  double trot_seconds = 6.2;  // s, from the start
  double after_seconds = 6;   // s, of the trot at the end
};

// How a skill ended.
enum class outcome : std::uint8_t { not_begun, going_on, done, timed_out };

struct episode {
  outcome how = outcome::not_begun;
  double begin = 0, end = 0;    // s
  double error = std::nan("");  // between joints and commands, when it ended, rad
};

struct result {
  bool fell = false;
  int last = 0;  // the last step of the plan
  double seconds = 0;
  double reach_error = std::nan("");       // m, mean while the paw is at the ball, before the push
  double worst_error = std::nan("");       // m, largest in that time
  double error_after_push = std::nan("");  // m, mean after the push
  double worst_after_push = std::nan("");  // m, largest after the push
  double reach_time = std::nan("");        // s
  double speed_after = 0;                  // m/s
  std::array<episode, plan::count> skills{};

  template <cca::fixed_string Name>
  const episode& of() const {
    return skills[static_cast<std::size_t>(plan::at<Name>)];
  }
  bool touched() const { return of<"reach">().how == outcome::done; }
};

inline cca::sim::initial_posture put_down(const orders::parameters& p, const cca::sim::disturbance& d) {
  cca::sim::initial_posture posture;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& foot = oncilla::is_front(i) ? p.trot.front : p.trot.hind;
    const auto q = cca::sim::leg_angles_for(cca::sim::oncilla_defaults, {foot.ahead, -foot.below});
    posture.legs[i] = {q.hip + d.hip_offset[i], q.knee + d.knee_offset[i], 0};
  }
  posture.trunk_velocity = d.trunk_velocity;
  return posture;
}

// The distance between the joints and their commands.
template <class Controller>
double tracking_error(const Controller& controller) {
  double error = std::nan("");
  controller.observed([&](const cca::observation& one) {
    if (one.path == "dmp.criterion.error") error = one.values[0];
  });
  return error;
}

// A run of a controller that is loaded: `begin` puts the robot down before start(), `note` looks at each beat
// and says whether the run goes on, `end` gives the figures.
class noted_run {
public:
  explicit noted_run(const circumstances& what) : c(what), around(c.where, c.paw, c.trot_seconds) {}

  template <class Stage>
  void begin(Stage& stage) {
    disturbance = c.seed ? cca::sim::disturbance::from_seed(*c.seed, c.trot_seconds + 15 + c.after_seconds)
                         : cca::sim::disturbance::none();
    stage.put_down(cca::sim::world(cca::sim::oncilla_defaults,
                                   cca::sim::terrain::flat().with_friction(disturbance.friction),
                                   put_down(stage.controller.template get<"orders">().p, disturbance)),
                   disturbance);
    look(stage);
  }

  // After a beat.
  template <class Stage>
  bool note(Stage& stage) {
    const int before = step_before;
    note_skills(stage, before);
    const bool over = note_world(stage, before);
    if (over || r.fell || time > most_seconds) return false;
    look(stage);
    return true;
  }

  result end() {
    if (count > 0) r.reach_error = sum / count;
    if (late_count > 0) r.error_after_push = late_sum / late_count;
    if (r.touched()) r.reach_time = r.of<"reach">().end - r.of<"reach">().begin;
    return r;
  }

private:
  static constexpr double most_seconds = 60, measured = 0.4, push_seconds = 0.06;

  template <class Stage>
  static const auto& sequencer(Stage& stage) {
    return stage.controller.template get<"sequencer">().steps;
  }

  // What the camera sees in the next beat.
  template <class Stage>
  void look(Stage& stage) {
    auto& camera = stage.controller.template get<"camera">();
    time = stage.world().time();
    step_before = sequencer(stage).step();
    const auto ball = around.seen(stage.world(), step_before > plan::at<"stop">);
    camera.sees = ball.has_value();
    if (ball) camera.ball = *ball;
  }

  template <class Stage>
  void note_skills(Stage& stage, int before) {
    const int now_on = sequencer(stage).step();
    if (now_on != before) {
      episode& ended = r.skills[static_cast<std::size_t>(before)];
      ended.how = sequencer(stage).timed_out() ? outcome::timed_out : outcome::done;
      ended.end = time;
      ended.error = tracking_error(stage.controller);
    }
    if (now_on != before || r.skills[static_cast<std::size_t>(now_on)].how == outcome::not_begun)
      r.skills[static_cast<std::size_t>(now_on)] = {outcome::going_on, time, time};
  }

  // True: it is over.
  template <class Stage>
  bool note_world(Stage& stage, int before) {
    const auto& world = stage.world();
    const int now_on = sequencer(stage).step();
    const double since = time - r.skills[static_cast<std::size_t>(now_on)].begin;
    if (now_on == plan::at<"touch">) note_touch(stage, since);
    if (now_on == plan::at<"trot on"> && before != now_on) from = world.trunk_position();
    r.last = now_on;
    r.seconds = world.time();
    r.fell = world.fallen();
    const bool over = now_on == plan::at<"trot on"> && since >= c.after_seconds;
    if (over) {
      const auto to = world.trunk_position();
      r.speed_after = std::hypot(to[0] - from[0], to[1] - from[1]) / c.after_seconds;
    }
    return over;
  }

  template <class Stage>
  void note_touch(Stage& stage, double since) {
    const double error = around.distance(stage.world()).value_or(std::nan(""));
    if (since >= measured) {
      late_sum += error, ++late_count;
      r.worst_after_push = std::fmax(r.worst_after_push, error);
      return;
    }
    sum += error;
    ++count;
    r.worst_error = std::fmax(r.worst_error, error);
    if (c.push > 0 && count == 1) {
      const double side = c.seed.value_or(0) % 2 ? 1.0 : -1.0;
      disturbance.another = {time + measured, push_seconds, {0, side * c.push, 0}};
      stage.disturb(disturbance);
    }
  }

  circumstances c;
  scene around;
  cca::sim::disturbance disturbance{};
  result r{};
  double time = 0;  // s, when the beat began
  int step_before = 0;
  double sum = 0, late_sum = 0;
  int count = 0, late_count = 0;
  cca::sim::vector3 from{};
};

struct simulated_stage {
  combined& controller;
  const cca::sim::world& world() const { return controller.get<"robot.simulator">().world(); }
  void put_down(cca::sim::world&& w, const cca::sim::disturbance& d) {
    controller.get<"robot.simulator">().put_down(std::move(w), d);
  }
  void disturb(const cca::sim::disturbance& d) { controller.get<"robot.simulator">().disturb(d); }
  void step() { controller.step(); }
};

// A whole run, as fast as possible. Calls between(controller) after each beat, and ends if it returns false.
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

template <class Between>
result roll_out(combined& controller, const circumstances& c, Between between) {
  simulated_stage stage{controller};
  return act(stage, c, between);
}

}  // namespace skills
