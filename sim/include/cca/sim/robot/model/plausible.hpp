// Whether a robot's world is still one that can be: a bound for the motion of each body.
//
//   speed    1000 m/s, of its centre of mass
//   turning  half a turn in a physics step: beyond it nothing tells how far a joint has turned
//   energy   10 MJ, kinetic, of all bodies
//   stop     half a radian (a slider: 0.1 m) beyond a stop
//
// A world looks at its bodies before and after each physics step. At the first body beyond a bound, or whose
// numbers are not finite, it stands still and keeps its last readings (robot_world.hpp), and the robot's node
// ends in a fault (simulated_robot.hpp). All bounds are CHOSEN.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>

#include <cca/sim/robot/model/robot_model.hpp>

namespace cca::sim {

struct plausible_bounds {
  double speed = 1000;                // m/s
  double turn = std::numbers::pi;     // rad, in a physics step
  double energy = 1e7;                // J
  double stop = 0.5, stop_way = 0.1;  // rad, m

  bool operator==(const plausible_bounds&) const = default;

  static constexpr plausible_bounds none() {
    constexpr double most = std::numeric_limits<double>::infinity();
    return {most, most, most, most, most};
  }
};

enum class implausible : std::uint8_t { nothing, number, speed, turning, energy, stop, engine };

struct world_trouble {
  static constexpr int base = -1, first_ball = -2;  // ball k: first_ball - k

  implausible what = implausible::nothing;
  int body = 0;  // a link, the base or a ball; of `energy` the one with most, of `engine` none in particular
  double value = 0, bound = 0;

  explicit operator bool() const { return what != implausible::nothing; }
};

namespace detail {

inline std::string name_of_body(const robot_model& m, int body) {
  if (body == world_trouble::base) return "the base";
  if (body <= world_trouble::first_ball) return "ball " + std::to_string(world_trouble::first_ball - body);
  const auto c = static_cast<std::size_t>(m.links[static_cast<std::size_t>(body)].coordinate);
  return "link " + std::to_string(body) + ", which `" + m.joint_name(c) + "` moves";
}

}  // namespace detail

// What happened, with the body, its number and the bound. Allocates.
inline std::string text_of(const world_trouble& t, const robot_model& m) {
  if (!t) return "";
  if (t.what == implausible::engine) return "the physics engine gives up: no step has a solution";
  const auto number = [](double x) {
    std::array<char, 32> digits{};
    std::snprintf(digits.data(), digits.size(), "%.4g", x);
    return std::string(digits.data());
  };
  const std::string of = detail::name_of_body(m, t.body),
                    beyond = number(t.value) + " is beyond " + number(t.bound);
  switch (t.what) {
    case implausible::number:
      return of + ": its motion is not finite";
    case implausible::speed:
      return of + ": its speed of " + beyond + " m/s";
    case implausible::turning:
      return of + ": its turning of " + beyond + " rad/s, half a turn in a physics step";
    case implausible::energy:
      return of + ": with its motion, the kinetic energy of " + beyond + " J";
    default:
      return of + ": its joint has passed a stop by " + beyond;
  }
}

}  // namespace cca::sim
