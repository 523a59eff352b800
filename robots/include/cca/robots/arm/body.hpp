// The body of the arm: the light-weight arm Franka Emika Panda, with its tool end at the flange.
//
// Published: masses, centres and inertias, identified by C. Gaz, M. Cognetti, A. Oliva, P. Robuffo Giordano,
// A. De Luca, "Dynamic Identification of the Franka Emika Panda Robot With Retrieval of Feasible Parameters
// Using Penalty-Based Optimization", IEEE Robotics and Automation Letters 4(4), 2019. They reproduce the
// torques of the robot; single numbers, such as the inertia of the first link across its axis, can't be
// identified and are only physically possible. The lengths are the maker's (modified Denavit-Hartenberg
// parameters, Franka Control Interface). Units: m, kg, kg m^2.
//
// The base frame stands on the floor, z up; the flange's z points out of the arm.
#pragma once

#include <array>
#include <numbers>

#include <cca/robot/body.hpp>
#include <cca/robots/arm/axes.hpp>

namespace cca::robots::arm {

struct base_frame : cca::frame<"arm base"> {};
struct flange_frame : cca::frame<"flange"> {};

namespace detail {

constexpr cca::placement next(double x, double y, double z, int quarter_turns_about_x) {
  return cca::at(x, y, z) * cca::turned_about(cca::along_x, quarter_turns_about_x * std::numbers::pi / 2);
}

}  // namespace detail

struct chain : cca::serial_chain<base_frame, flange_frame, joint_axes> {
  static constexpr std::array joints{cca::revolute(cca::along_z, detail::next(0, 0, 0.333, 0)),
                                     cca::revolute(cca::along_z, detail::next(0, 0, 0, -1)),
                                     cca::revolute(cca::along_z, detail::next(0, -0.316, 0, 1)),
                                     cca::revolute(cca::along_z, detail::next(0.0825, 0, 0, 1)),
                                     cca::revolute(cca::along_z, detail::next(-0.0825, 0.384, 0, -1)),
                                     cca::revolute(cca::along_z, detail::next(0, 0, 0, 1)),
                                     cca::revolute(cca::along_z, detail::next(0.088, 0, 0, 1))};
  static constexpr auto tip = cca::at(0, 0, 0.107);

  // Mass; centre; xx, yy, zz, xy, xz, yz about the centre.
  static constexpr std::array links{
      cca::link_inertia{4.970684,
                        {0.003875, 0.002081, -0.04762},
                        {0.70337, 0.70661, 0.009117, -0.000139, 0.006772, 0.019169}},
      cca::link_inertia{0.646926,
                        {-0.003141, -0.02872, 0.003495},
                        {0.007962, 0.02811, 0.025995, -0.003925, 0.010254, 0.000704}},
      cca::link_inertia{3.228604,
                        {0.027518, 0.039252, -0.066502},
                        {0.037242, 0.036155, 0.01083, -0.004761, -0.011396, -0.012805}},
      cca::link_inertia{3.587895,
                        {-0.05317, 0.104419, 0.027454},
                        {0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641}},
      cca::link_inertia{1.225946,
                        {-0.011953, 0.041065, -0.038437},
                        {0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229}},
      cca::link_inertia{1.666555,
                        {0.060149, -0.014117, -0.010517},
                        {0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341}},
      cca::link_inertia{0.735522,
                        {0.010517, -0.004252, 0.061597},
                        {0.012516, 0.010027, 0.004815, -0.000428, -0.001196, -0.000741}}};
};

struct body : cca::body<base_frame,
                        cca::part<"arm", chain, cca::driven_by<"a1", "a2", "a3", "a4", "a5", "a6", "a7">>> {};

}  // namespace cca::robots::arm
