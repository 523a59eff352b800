// What stands around a robot in a compiled world: constants that a scene gives.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <cca/sim/compiled/around/balls.hpp>
#include <cca/sim/compiled/around/boxes.hpp>
#include <cca/sim/compiled/around/ground.hpp>
#include <cca/sim/engine/checked_scene.hpp>
#include <cca/sim/engine/scene.hpp>
#include <cca/sim/robot/model/plausible.hpp>

namespace cca::sim::detail {

struct surroundings {
  ground under{};
  boxes_around boxes{};
  balls_around balls{};
  double friction = 0;  // of boxes and balls; the ground has its own

  bool exist() const { return under.exists || more(); }
  bool more() const { return boxes.count + balls.count > 0; }  // than ground
  bool goes_with(const surroundings& b) const {
    return !more() && !b.more() && under.goes_with(b.under) && friction == b.friction;
  }
};

// Lanes have a ground each, and no boxes and balls.
template <class Real>
struct surroundings_in_lanes {
  ground_in_lanes<Real> under{};
  double friction = 0;  // as of the others; of shapes of one robot

  constexpr surroundings_in_lanes() = default;
  surroundings_in_lanes(const surroundings& all) : under(all.under), friction(all.friction) {}
  // `take_lane` of each lane, in their order; they go together.
  void take_lane(int k, const surroundings& one) {
    under.take_lane(k, one.under);
    friction = one.friction;
  }
  static constexpr bool more() { return false; }
};
template <class Real>
using surroundings_for = std::conditional_t<is_in_lanes<Real>, surroundings_in_lanes<Real>, surroundings>;

// Throws std::invalid_argument for what no world can have, and for what this one has not.
template <class Real>
surroundings surroundings_of(const scene& around, const engine_settings& settings, bool has_shapes) {
  if (is_in_lanes<Real> && !(around.boxes.empty() && around.balls.empty()))
    throw std::invalid_argument(
        "cca::sim::compiled_world: worlds in lanes have no boxes and no balls; leave them out of the scene, "
        "or "
        "make the worlds one by one");
  if (!has_shapes && !around.balls.empty())
    throw std::invalid_argument(
        "cca::sim::compiled_world: the robot has no shapes, so nothing of it touches the balls of the "
        "scene; leave them out, or use cca::sim::robot_world");
  surroundings s;
  s.under = ground_of(around, settings);  // checks the scene
  const auto need_few = [](std::size_t count, std::size_t most, const std::string& things) {
    if (count <= most) return;
    throw std::invalid_argument("cca::sim::compiled_world: the scene has " + std::to_string(count) + " " +
                                things + ", and there is room for " + std::to_string(most) +
                                "; leave some out, or use cca::sim::robot_world, which takes any number");
  };
  need_few(around.boxes.size(), boxes_around::most, "boxes");
  need_few(around.balls.size(), balls_around::most, "balls");
  s.friction = around.contact.friction;
  for (const fixed_box& b : around.boxes) {
    auto& half = s.boxes.half[s.boxes.count++];
    for (std::size_t k = 0; k < 3; ++k) half[k] = b.size[k] / 2;
  }
  for (const ball& b : around.balls) s.balls.all[s.balls.count++] = {b.radius, b.mass};
  return s;
}

// Where they are and how they move.
template <class Real>
struct motion_around {
  std::array<box_motion, boxes_around::most> boxes{};
  std::array<ball_motion<Real>, balls_around::most> balls{};

  void begin(const scene& around) {
    for (std::size_t i = 0; i < around.boxes.size(); ++i) boxes[i].put(around.boxes[i].where);
    for (std::size_t i = 0; i < around.balls.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        balls[i].at[k] = Real(around.balls[i].position[k]);
        balls[i].velocity[k] = Real(around.balls[i].velocity[k]);
      }
  }
  // Of balls; boxes follow the beat.
  void drift(const surroundings& of, double time) {
    for (std::size_t i = 0; i < of.balls.count; ++i) balls[i].drift(time);
  }
  // The first ball that can't be right.
  world_trouble trouble(const surroundings& of, const plausible_bounds& bounds, double step) const {
    for (std::size_t i = 0; i < of.balls.count; ++i) {
      const auto& [at, velocity, turning] = balls[i];
      const auto& made = of.balls.all[i];
      const int name = world_trouble::first_ball - static_cast<int>(i);
      const Real speed = root(dot(velocity, velocity)), turns = root(dot(turning, turning)),
                 energy = Real(made.mass / 2) * speed * speed + Real(made.inertia() / 2) * turns * turns,
                 sum = speed + turns + energy + (at[0] + at[1] + at[2]);
      if (!everywhere(sum - sum == Real(0.0))) return {implausible::number, name};
      const auto is_beyond = [](const Real& x, double bound) { return !everywhere(x <= Real(bound)); };
      if (is_beyond(speed, bounds.speed)) return {implausible::speed, name, plain(speed), bounds.speed};
      if (is_beyond(Real(step) * turns, bounds.turn))
        return {implausible::turning, name, plain(turns), bounds.turn / step};
      if (is_beyond(energy, bounds.energy)) return {implausible::energy, name, plain(energy), bounds.energy};
    }
    return {};
  }
  void end_beat(const surroundings& of, double beat) {
    for (std::size_t i = 0; i < of.boxes.count; ++i) boxes[i].end_beat(beat);
  }
};

}  // namespace cca::sim::detail
