#pragma once
// What happens to the arm in a run: somebody leads its hand, a table moves, somebody pushes it. All of it
// follows from the seed.
#include <algorithm>
#include <cstdint>
#include <numbers>
#include <random>
#include <type_traits>

#include <Eigen/Core>

#include <cca/base/math.hpp>
#include <cca/mapping/placement.hpp>
#include <cca/sim/engine/scene.hpp>
#include <cca/sim/robot/model/robot_model.hpp>

#include "plan.hpp"

namespace touch {

// Of the world on the tool, along the axes of the world, N: the mean of the last beat.
template <class World>
Eigen::Vector3d force_on_tool(const World& world) {
  const auto& felt = world.load(0);
  return world.end(0).where.turn * Eigen::Vector3d(felt[3], felt[4], felt[5]);
}

class scene {
public:
  static constexpr double table_height = 0.25, guided_for = 4;  // m, s
  static constexpr double push_force = 20, push_for = 1;        // N, s

  explicit scene(std::uint64_t seed) {
    std::mt19937_64 dice(seed);
    const auto within = [&dice](double low, double high) {
      return low + (high - low) * static_cast<double>(dice() >> 11) * 0x1p-53;
    };
    const double side = within(-1, 1) < 0 ? -1 : 1;
    end = {within(0.1, 0.2), side * within(0.15, 0.25), within(-0.15, -0.05)};
    bow = {within(-0.05, 0.05), within(-0.05, 0.05), within(0.02, 0.08)};
    turn = {within(-0.3, 0.3), within(-0.3, 0.3), within(-0.4, 0.4)};
    const double shift_to = within(-std::numbers::pi, std::numbers::pi);
    const auto [sine, cosine] = cca::math::sine_and_cosine(shift_to);
    shift = 0.1 * Eigen::Vector3d(cosine, 0.8 * sine, 0.6 * sine);
    const double tilts_about = within(-std::numbers::pi, std::numbers::pi);
    tilt_axis = {cca::math::cos(tilts_about), cca::math::sin(tilts_about), 0};
    tilt = within(0.5, 1) * std::numbers::pi / 18;
    lift = within(-1, 1) < 0 ? -0.02 : 0.02;
    const double pushed_to = within(-std::numbers::pi, std::numbers::pi);
    push = push_force * Eigen::Vector3d(cca::math::cos(pushed_to), cca::math::sin(pushed_to), 0);
  }

  static cca::sim::scene room() {
    cca::sim::scene room;
    room.contact.friction = 0.3;
    room.add(table(0, Eigen::Vector3d::UnitX(), 0));
    return room;
  }

  // The arm in a room, in either engine.
  template <class World>
  static World arm_in_room(const cca::sim::scene& room = scene::room(),
                           const cca::sim::robot_world_settings& settings = {}) {
    if constexpr (std::is_constructible_v<World, const cca::sim::scene&>) return World(room, settings);
    else return World(cca::sim::model_of<arm::description>(), room, settings);
  }

  // Before a beat; `in_step`: s since the step began.
  template <class World>
  void act(World& world, int step, double in_step) {
    if (step == plan::at<"guided">) lead(world, in_step);
    else if (step == plan::at<"wipe">) {
      const double share = smooth((in_step - 2) / 0.6);
      if (share > 0 && share <= 1) world.move(0, table(share * tilt, tilt_axis, share * lift).where);
      pull(world, in_step > 6 && in_step < 6 + push_for ? push : Eigen::Vector3d(0, 0, 0));
      pushed_until = world.time() + push_for - (in_step > 6 ? in_step - 6 : 0);
    } else if (step == plan::at<"yield"> && world.time() < pushed_until) {
      pull(world, push);
    } else {
      pull(world, {0, 0, 0});
    }
  }

  // Of the table as it stands at the end of its movement.
  Eigen::Vector3d normal(double in_wipe) const {
    const double share = std::clamp(smooth((in_wipe - 2) / 0.6), 0.0, 1.0);
    return cca::rotation::rotate<double>(cca::rotation::about<double>(tilt_axis, share * tilt), {0, 0, 1});
  }

  Eigen::Vector3d shift;             // of the second goal, 0.1 m
  Eigen::Vector3d another{0, 0, 0};  // what somebody else pulls at the hand, N

private:
  static double smooth(double s) {
    s = std::clamp(s, 0.0, 1.0);
    return s * s * s * (10 - 15 * s + 6 * s * s);
  }

  // Turned about the middle of its top.
  static cca::sim::fixed_box table(double angle, const Eigen::Vector3d& axis, double up) {
    return {{0.8, 1.2, 0.04},
            cca::at(0.5, 0, table_height + up) * cca::turned_about({axis[0], axis[1], axis[2]}, angle) *
                cca::at(0, 0, -0.02)};
  }

  template <class World>
  void pull(World& world, const Eigen::Vector3d& force, const Eigen::Vector3d& torque = {0, 0, 0}) {
    world.pull(0, force + another, torque);
  }

  // A hand that holds the flange by a spring and goes the way that it wants to show.
  template <class World>
  void lead(World& world, double time) {
    const auto now = world.end(0);
    if (time <= 0.001) begin = now.where.at, upright = now.where.turn;
    if (time > guided_for + 1.5) return pull(world, {0, 0, 0});
    const double s = std::min(time / guided_for, 1.0), share = smooth(s), bent = s * (1 - s);
    const Eigen::Vector3d wanted = begin + share * end + 64 * bent * bent * bent * bow;
    const Eigen::Matrix3d held = cca::rotation::matrix(cca::rotation::exp<double>(share * turn)) * upright;
    const Eigen::Vector3d off =
        cca::rotation::log(cca::rotation::from_matrix<double>(held * now.where.turn.transpose()));
    pull(world, 400 * (wanted - now.where.at) - 40 * now.velocity, 10 * off - 0.6 * now.angular_velocity);
  }

  Eigen::Vector3d end, bow, turn, tilt_axis, push, begin{};
  Eigen::Matrix3d upright{};
  double tilt, lift, pushed_until = 0;
};

}  // namespace touch
