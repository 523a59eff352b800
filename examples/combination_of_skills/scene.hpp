#pragma once
// The ball: in reach of the robot when it stops, or fixed in the world in front of it.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include <cca/sim/oncilla/asked_by_leg.hpp>

#include "legs.hpp"

namespace skills {

enum class target : std::uint8_t { ahead, high, inside, world };
inline constexpr std::array<std::string_view, 4> target_names{"ahead", "high", "inside", "world"};
inline constexpr std::array<std::string_view, 2> paw_names{"left", "right"};

class scene {
public:
  scene(target where, paw_side paw, double trot_seconds)
      : where_(where), leg_(paw == paw_side::right ? 1 : 0), shown_at_(trot_seconds) {
    if (where == target::world)
      ball_ = Eigen::Vector3d(fixed_ahead, oncilla::side_of(leg_) * cca::sim::oncilla_defaults.hip_y,
                              fixed_height);
  }

  std::size_t leg() const { return leg_; }

  // The ball in the trunk's frame, if a camera on the trunk sees it. A ball that isn't fixed in the world
  // appears in front of the robot after `trot_seconds`, and moves with it until it stops.
  template <class World>  // asked by leg, whatever engine it has
  std::optional<Eigen::Vector3d> seen(const World& world, bool stopped) {
    const Eigen::Vector3d trunk = vector(world.trunk_position());
    const cca::sim::quaternion& q = world.reading().trunk.orientation;
    const Eigen::Vector4d turn(q.x, q.y, q.z, q.w);
    if (!ball_) {
      if (world.time() < shown_at_) return {};
      const Eigen::Vector3d place = hip_in_trunk(leg_) + beside(places[static_cast<std::size_t>(where_)]);
      if (!stopped) return place;
      ball_ = Eigen::Vector3d(trunk + cca::rotation::rotate(turn, place));
    }
    return cca::rotation::rotate<double>(cca::rotation::inverse(turn), *ball_ - trunk);
  }

  // The true distance from paw to ball, which no sensor of the robot measures.
  template <class World>
  std::optional<double> distance(const World& world) const {
    if (!ball_) return {};
    return (vector(world.foot_position(leg_)) - *ball_).norm();
  }

private:
  // Ahead of the hip, outward, up; m.
  static constexpr std::array<std::array<double, 3>, 3> places{
      {{0.095, 0, -0.115}, {0.085, 0, -0.090}, {0.070, -0.015, -0.130}}};
  static constexpr double fixed_ahead = 4.15, fixed_height = 0.062;  // m

  Eigen::Vector3d beside(const std::array<double, 3>& p) const {
    return {p[0], oncilla::side_of(leg_) * p[1], p[2]};
  }
  static Eigen::Vector3d vector(const cca::sim::vector3& v) { return {v[0], v[1], v[2]}; }

  target where_;
  std::size_t leg_;
  double shown_at_;
  std::optional<Eigen::Vector3d> ball_;
};

}  // namespace skills
