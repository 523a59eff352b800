// A table on which balls roll towards an arm, seen from above: a simulated robot with one joint.
//
//   out "ball"      where the ball is: what the camera looks at
//   out "arm"       the angle of the arm; its hand is at y = reach * sin(angle), on the line x = 0
//   in  "command"   the angle that the arm shall have
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

#include <cca/cca.hpp>

namespace vision {

struct table_frame {};
struct point : cca::space<cca::cartesian_position<table_frame>, cca::axes<cca::x, cca::y>> {};

struct shoulder : cca::dimension<"shoulder"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.3, 1.3}, cca::velocity{-12, 12}};
};
struct arm_angle : cca::space<cca::joint_angles, cca::axes<shoulder>, cca::rate<1000>> {};

constexpr double length = 0.8, half_width = 0.25;  // of the table, m
constexpr double ball_radius = 0.02, hand_radius = 0.035, reach = 0.3;

class table {
public:
  auto sense() -> std::tuple<cca::out<"ball", point>, cca::out<"arm", arm_angle>> {
    return {at, cca::out<"arm", arm_angle>(angle)};
  }
  void act(cca::in<"command", arm_angle> command) {
    constexpr double dt = 1e-3, fastest = 6;  // rad/s
    angle += std::clamp(0.05 * (command[shoulder{}] - angle), -fastest * dt, fastest * dt);
    at += dt * speed;
    if (std::abs(at[1]) > half_width) {
      at[1] = std::clamp(at[1], -half_width, half_width);
      speed[1] = -speed[1];
    }
    if (at[0] > 0) return;
    caught += std::abs(at[1] - reach * cca::math::sin(angle)) < hand_radius;
    throw_next();
  }

  int thrown = 1, caught = 0;
  double angle = 0;

private:
  // The same balls in each run.
  void throw_next() {
    ++thrown;
    at = {length, half_width * dice()};
    speed = {-1.4 - 0.3 * dice(), 0.7 * dice()};
  }
  double dice() {  // from -1 to 1
    bits = bits * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(bits >> 11) * 0x1p-52 - 1;
  }

  Eigen::Vector2d at{length, 0.1}, speed{-1.2, 0.3};
  std::uint64_t bits = 7;
};

}  // namespace vision
