// A quadruped of twelve joints with a free base: a trunk and four legs of three joints, in the size of a
// robot of 12 kg. Lengths and inertias are chosen.
#pragma once

#include <array>

#include <cca/mapping/serial_chain.hpp>
#include <cca/robot/body.hpp>

namespace bench {

struct trunk : cca::frame<"trunk"> {};
template <int Leg>
struct foot {};
template <int Leg, int Joint>
struct leg_joint : cca::dimension<"leg"> {};

template <int Leg>
struct leg : cca::serial_chain<trunk,
                               foot<Leg>,
                               cca::axes<leg_joint<Leg, 0>, leg_joint<Leg, 1>, leg_joint<Leg, 2>>> {
  static constexpr double front = Leg < 2 ? 1 : -1, left = Leg % 2 == 0 ? 1 : -1;
  static constexpr std::array joints{cca::revolute(cca::along_x, cca::at(0.18 * front, 0.05 * left, 0)),
                                     cca::revolute(cca::along_y, cca::at(0, 0.09 * left, 0)),
                                     cca::revolute(cca::along_y, cca::at(0, 0, -0.2))};
  static constexpr auto tip = cca::at(0, 0, -0.2);
  static constexpr std::array links{
      cca::link_inertia{0.7, {-0.004 * front, 0.003 * left, 0}, {6e-4, 7e-4, 5e-4, 2e-5 * left, 1e-6, 2e-6}},
      cca::link_inertia{1.1, {-0.004, -0.02 * left, -0.03}, {6e-3, 6e-3, 1e-3, 2e-6, -2e-4, 2e-4 * left}},
      cca::link_inertia{0.2, {0.005, 0.001, -0.1}, {2e-3, 2e-3, 5e-5, 1e-6, 2e-5, 1e-6}}};
};
struct quadruped : cca::body<trunk,
                             cca::part<"left front", leg<0>>,
                             cca::part<"right front", leg<1>>,
                             cca::part<"left hind", leg<2>>,
                             cca::part<"right hind", leg<3>>> {
  static constexpr cca::link_inertia base{5, {0.005, 0.002, -0.001}, {0.02, 0.04, 0.05, 1e-4, -1e-4, -3e-5}};
};

}  // namespace bench
