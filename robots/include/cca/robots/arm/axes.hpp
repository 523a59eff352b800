// The axes of the arm: seven joints, from the base to the flange, with their limits.
//
// Published by the maker of the Franka Emika Panda (Franka Control Interface, "Robot and interface
// specifications"): ranges of angle, velocity and acceleration, torques and their rate. CHOSEN: the
// stiffness and the damping that may be commanded.
#pragma once

#include <cca/space/dimension.hpp>
#include <cca/space/limits.hpp>
#include <cca/space/space.hpp>

namespace cca::robots::arm {

namespace detail {

constexpr auto joint_limits(double low,
                            double high,
                            double speed,
                            double acceleration,
                            double torque,
                            double stiffness,
                            double damping) {
  return cca::limits{cca::angle{low, high},
                     cca::velocity{-speed, speed},
                     cca::acceleration{-acceleration, acceleration},
                     cca::torque{-torque, torque},
                     cca::torque_rate{-1000, 1000},
                     cca::stiffness{0, stiffness},
                     cca::damping{0, damping}};
}

}  // namespace detail

struct a1 : cca::dimension<"a1"> {
  static constexpr auto limits = detail::joint_limits(-2.8973, 2.8973, 2.175, 15, 87, 3000, 250);
};
struct a2 : cca::dimension<"a2"> {
  static constexpr auto limits = detail::joint_limits(-1.7628, 1.7628, 2.175, 7.5, 87, 3000, 250);
};
struct a3 : cca::dimension<"a3"> {
  static constexpr auto limits = detail::joint_limits(-2.8973, 2.8973, 2.175, 10, 87, 3000, 250);
};
struct a4 : cca::dimension<"a4"> {
  static constexpr auto limits = detail::joint_limits(-3.0718, -0.0698, 2.175, 12.5, 87, 3000, 250);
};
struct a5 : cca::dimension<"a5"> {
  static constexpr auto limits = detail::joint_limits(-2.8973, 2.8973, 2.61, 15, 12, 300, 6);
};
struct a6 : cca::dimension<"a6"> {
  static constexpr auto limits = detail::joint_limits(-0.0175, 3.7525, 2.61, 20, 12, 300, 6);
};
struct a7 : cca::dimension<"a7"> {
  static constexpr auto limits = detail::joint_limits(-2.8973, 2.8973, 2.61, 20, 12, 300, 6);
};

using joint_axes = cca::axes<a1, a2, a3, a4, a5, a6, a7>;

}  // namespace cca::robots::arm
