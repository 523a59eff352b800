// The robot: a cart on a rail, and a pole on it that nothing but the cart keeps upright.
//
// First its axes with their limits, then the body with its masses, then what drives it. The simulator builds
// its world from this, and the ports of the robot follow from it: "torque" in; "angles", "velocities" and
// "torques" out.
#pragma once

#include <array>

#include <cca/cca.hpp>
#include <cca/robot/body.hpp>
#include <cca/robots/description.hpp>
#include <cca/robots/ports.hpp>

namespace my_robot {

struct cart : cca::dimension<"cart"> {  // a prismatic joint: m, m/s, N
  static constexpr auto limits =
      cca::limits{cca::angle{-0.8, 0.8}, cca::velocity{-3, 3}, cca::torque{-20, 20}};
};
struct pole : cca::dimension<"pole"> {  // 0 is upright. It has no motor, so its torque is 0
  static constexpr auto limits =
      cca::limits{cca::angle{-1.5, 1.5}, cca::velocity{-20, 20}, cca::torque{0, 0}};
};

struct room : cca::frame<"room"> {};
struct pole_end : cca::frame<"pole end"> {};

struct chain : cca::serial_chain<room, pole_end, cca::axes<cart, pole>> {
  static constexpr std::array joints{cca::prismatic(cca::along_x, cca::at(0, 0, 0.1)),
                                     cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0, 0, 0.6);
  static constexpr std::array links{// mass in kg; centre in m; xx, yy, zz, xy, xz, yz in kg m^2
                                    cca::link_inertia{1.0, {0, 0, 0}, {0.002, 0.002, 0.002, 0, 0, 0}},
                                    cca::link_inertia{0.2, {0, 0, 0.3}, {0.006, 0.006, 0.0001, 0, 0, 0}}};
};
struct body : cca::body<room, cca::part<"pole", chain, cca::driven_by<"cart", "pole">>> {};

struct description {
  using body = my_robot::body;
  using rate = cca::rate<1000>;
  using commands = cca::robots::commands<cca::robots::torque_command>;
  static constexpr std::array drives{cca::robots::joint_drive{.motor = {20, 6}, .friction = 0.5},
                                     cca::robots::joint_drive{.friction = 0.001}};  // no motor
  static constexpr std::array shapes{
      cca::robots::on_link("pole", 0, cca::robots::box(0.2, 0.1, 0.06)),
      cca::robots::on_link("pole", 1, cca::robots::capsule(0.01, 0.58), cca::at(0, 0, 0.3))};
  static constexpr std::array start{0.0, 0.15};  // the pole leans
};

using angles = cca::robots::angles<description>;
using velocities = cca::robots::velocities<description>;
using torques = cca::robots::torques<description>;

}  // namespace my_robot
