#pragma once
// What a run of the Combination of Skills is judged by, whatever runs it: when each skill began and how it
// ended, how near the paw came to the ball, how fast the robot trotted on. It also shows the robot the ball,
// and pushes it once the paw is there.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include <cca/cca.hpp>
#include <cca/sim/oncilla/disturbance.hpp>
#include <cca/sim/engine/terrain.hpp>
#include <cca/sim/oncilla/asked_by_leg.hpp>
#include <cca/sim/robot/model/robot_world_settings.hpp>

#include "orders.hpp"
#include "plan.hpp"
#include "scene.hpp"

namespace skills {

struct circumstances {
  std::optional<std::uint64_t> seed = 0;  // none: no disturbance
  paw_side paw = paw_side::left;
  target where = target::ahead;
  double push = 20;           // N on the trunk from the side, while the paw is at the ball
  double trot_seconds = 6.2;  // s, from the start
  double after_seconds = 6;   // s, of the trot at the end
  // The ground, whose friction is a factor of the one that the seed has drawn; the physics.
  cca::sim::terrain ground = cca::sim::terrain::flat().with_friction(1);
  cca::sim::robot_world_settings physics{};
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

class referee {
public:
  explicit referee(const circumstances& run = {})
      : c(run),
        pushes(c.seed ? cca::sim::disturbance::from_seed(*c.seed, c.trot_seconds + 15 + c.after_seconds)
                      : cca::sim::disturbance::none()),
        around(c.where, c.paw, c.trot_seconds) {}

  template <class World>  // asked by leg, whatever engine it has
  World put_down(const orders::parameters& p) const {
    return World(c.ground.with_friction(pushes.friction * c.ground.friction()), skills::put_down(p, pushes),
                 c.physics);
  }
  const cca::sim::disturbance& disturbance() const { return pushes; }

  // Before a beat: the ball in the trunk's frame, if a camera on the trunk sees it.
  template <class World>
  std::optional<Eigen::Vector3d> ball(const World& world) {
    return around.seen(world, r.last > plan::at<"stop">);
  }

  // After a beat that began at `time`: the step that the sequencer is in now. `tracking_error()` is the
  // distance between joints and commands. True: `disturbance` has a push more than before.
  template <class World, class Error>
  bool note(double time, const World& world, int now_on, bool timed_out, Error tracking_error) {
    const int before = r.last;
    if (now_on != before) {
      episode& ended = r.skills[static_cast<std::size_t>(before)];
      ended.how = timed_out ? outcome::timed_out : outcome::done;
      ended.end = time;
      ended.error = tracking_error();
    }
    if (now_on != before || r.skills[static_cast<std::size_t>(now_on)].how == outcome::not_begun)
      r.skills[static_cast<std::size_t>(now_on)] = {outcome::going_on, time, time};
    const double since = time - r.skills[static_cast<std::size_t>(now_on)].begin;
    const bool pushes_now = now_on == plan::at<"touch"> && note_distance(time, since, world);
    if (now_on == plan::at<"trot on"> && before != now_on) from = world.trunk_position();
    r.last = now_on;
    r.seconds = world.time();
    r.fell = world.fallen();
    const bool has_trotted_on = now_on == plan::at<"trot on"> && since >= c.after_seconds;
    if (has_trotted_on) {
      const auto to = world.trunk_position();
      r.speed_after = cca::math::hypot(to[0] - from[0], to[1] - from[1]) / c.after_seconds;
    }
    over = has_trotted_on || r.fell || time > most_seconds;
    return pushes_now;
  }

  bool is_over() const { return over; }

  result judgement() const {
    result all = r;
    if (count > 0) all.reach_error = sum / count;
    if (late_count > 0) all.error_after_push = late_sum / late_count;
    if (all.touched()) all.reach_time = all.of<"reach">().end - all.of<"reach">().begin;
    return all;
  }

private:
  static constexpr double most_seconds = 60, measured = 0.4, push_seconds = 0.06;

  // While the paw is at the ball, for `since` seconds.
  template <class World>
  bool note_distance(double time, double since, const World& world) {
    const double error = around.distance(world).value_or(std::nan(""));
    if (since >= measured) {
      late_sum += error, ++late_count;
      r.worst_after_push = std::fmax(r.worst_after_push, error);
      return false;
    }
    sum += error;
    ++count;
    r.worst_error = std::fmax(r.worst_error, error);
    if (c.push <= 0 || count != 1) return false;
    const double side = c.seed.value_or(0) % 2 ? 1.0 : -1.0;
    pushes.another = {time + measured, push_seconds, {0, side * c.push, 0}};
    return true;
  }

  circumstances c;
  cca::sim::disturbance pushes;
  scene around;
  result r;
  double sum = 0, late_sum = 0;
  int count = 0, late_count = 0;
  cca::sim::vector3 from{};
  bool over = false;
};

}  // namespace skills
