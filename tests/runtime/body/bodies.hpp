// Bodies for the tests: a dog with a pantograph leg, a star of two of its parts, and an arm of seven joints.
#pragma once

#include <cca/mapping/serial_chain.hpp>
#include <cca/robot/body.hpp>

namespace body_test {

struct trunk : cca::frame<"trunk"> {};
struct hip : cca::frame<"hip"> {};
struct paw : cca::frame<"paw"> {};
struct toe : cca::frame<"toe"> {};
struct tail_end : cca::frame<"tail"> {};
struct sensor : cca::frame<"sensor"> {};

struct a : cca::dimension<"a"> {};
struct b : cca::dimension<"b"> {};
struct c : cca::dimension<"c"> {};
struct d : cca::dimension<"d"> {};
struct e : cca::dimension<"e"> {};

using cca::along_y, cca::along_z, cca::prismatic, cca::revolute, cca::turned_about;
inline constexpr auto at = [](double x, double y, double z) { return cca::at(x, y, z); };

struct hip_chain : cca::serial_chain<trunk, hip, cca::axes<a>> {
  static constexpr std::array joints{revolute({1, 0.2, 0}, at(0.2, 0.1, 0))};
  static constexpr auto tip = at(0, 0.05, 0) * turned_about({1, 1, 1}, 0.5);
  static constexpr std::array links{
      cca::link_inertia{0.3, {0, 0.02, 0.01}, {2e-3, 3e-3, 4e-3, 1e-4, -2e-4, 3e-4}}};
};
// A pantograph: two joints of one coordinate.
struct leg_chain : cca::serial_chain<hip, paw, cca::axes<b, c>> {
  static constexpr std::array joints{revolute(along_y).driven_by(0, -1),
                                     revolute(along_y, at(0, 0, -0.08)).driven_by(1),
                                     revolute(along_y, at(0, 0, -0.09)).driven_by(1, -1, 0.1)};
  static constexpr auto tip = at(0, 0, -0.06);
  static constexpr std::array links{cca::link_inertia{0.2, {0, 0, -0.04}, {1e-3, 1e-3, 1e-4, 0, 0, 0}},
                                    cca::link_inertia{0.1, {0, 0.01, -0.05}, {5e-4, 5e-4, 1e-4, 0, 0, 1e-5}},
                                    cca::link_inertia{0.05, {0.01, 0, -0.03}, {1e-4, 1e-4, 1e-5, 0, 0, 0}}};
};
struct toe_chain : cca::serial_chain<paw, toe, cca::axes<d>> {
  static constexpr std::array joints{prismatic({0, 1, 2}, at(0.01, 0, 0)).driven_by(0, 0.7)};
  static constexpr auto tip = at(0.02, 0, 0);
  static constexpr std::array links{cca::link_inertia{0.04, {0.01, 0, 0}, {1e-5, 1e-5, 1e-5, 0, 0, 0}}};
};
struct tail_chain : cca::serial_chain<trunk, tail_end, cca::axes<e>> {  // without a stated mass
  static constexpr std::array joints{revolute(along_z, at(-0.2, 0, 0.05))};
  static constexpr auto tip = at(-0.1, 0, 0);
};
struct sensor_place : cca::serial_chain<tail_end, sensor, cca::axes<>> {  // no joints
  static constexpr std::array<cca::joint, 0> joints{};
  static constexpr auto tip = at(0, 0, 0.01) * turned_about(along_y, 1);
};

// Declared from the ends: each part comes before the one to which it is attached.
struct dog : cca::body<trunk,
                       cca::part<"toe", toe_chain>,
                       cca::part<"sensor", sensor_place>,
                       cca::part<"leg", leg_chain>,
                       cca::part<"tail", tail_chain>,
                       cca::part<"hip", hip_chain, cca::driven_by<"hip", "legs.motor">>> {
  static constexpr cca::link_inertia base{3, {0.01, 0, 0.02}, {1e-2, 5e-2, 5e-2, 1e-3, 0, 0}};
};
struct star : cca::body<trunk, cca::part<"hip", hip_chain>, cca::part<"tail", tail_chain>> {};

// All of its links have mass.
struct hound
    : cca::
          body<trunk, cca::part<"toe", toe_chain>, cca::part<"leg", leg_chain>, cca::part<"hip", hip_chain>> {
  static constexpr cca::link_inertia base{3, {0.01, 0, 0.02}, {1e-2, 5e-2, 5e-2, 1e-3, 0, 0}};
};

// Seven joints in the order of a light-weight arm; lengths and inertias are chosen.
struct arm_base : cca::frame<"arm base"> {};
struct flange : cca::frame<"flange"> {};
template <cca::fixed_string Name>
struct arm_joint : cca::dimension<Name> {
  static constexpr auto limits = cca::limits{cca::angle{-2.9, 2.9}, cca::torque{-200, 200}};
};
struct a1 : arm_joint<"a1"> {};
struct a2 : arm_joint<"a2"> {};
struct a3 : arm_joint<"a3"> {};
struct a4 : arm_joint<"a4"> {};
struct a5 : arm_joint<"a5"> {};
struct a6 : arm_joint<"a6"> {};
struct a7 : arm_joint<"a7"> {};
using arm_axes = cca::axes<a1, a2, a3, a4, a5, a6, a7>;

struct arm_chain : cca::serial_chain<arm_base, flange, arm_axes> {
  static constexpr std::array joints{revolute(along_z, at(0, 0, 0.11)), revolute(along_y, at(0, 0, 0.2)),
                                     revolute(along_z, at(0, 0, 0.2)),  revolute(along_y, at(0, 0, 0.2)),
                                     revolute(along_z, at(0, 0, 0.2)),  revolute(along_y, at(0, 0, 0.19)),
                                     revolute(along_z, at(0, 0, 0.08))};
  static constexpr auto tip = at(0, 0, 0.05);
  static constexpr std::array links{
      cca::link_inertia{2.7, {0, -0.03, 0.12}, {0.016, 0.015, 0.006, 0, 0, 1e-3}},
      cca::link_inertia{2.7, {0, 0.05, 0.07}, {0.016, 0.007, 0.014, 0, 0, 1e-3}},
      cca::link_inertia{2.7, {0, 0.03, 0.12}, {0.016, 0.015, 0.006, 0, 0, -1e-3}},
      cca::link_inertia{2.7, {0, -0.05, 0.07}, {0.016, 0.007, 0.014, 0, 0, -1e-3}},
      cca::link_inertia{1.7, {0, -0.02, 0.1}, {0.01, 0.009, 0.003, 0, 0, 1e-3}},
      cca::link_inertia{1.6, {0, 0.01, 0.01}, {0.003, 0.003, 0.003, 0, 0, 0}},
      cca::link_inertia{0.3, {0, 0, 0.02}, {1e-3, 1e-3, 1e-3, 0, 0, 0}}};
};
struct arm : cca::body<arm_base, cca::part<"arm", arm_chain>> {
  static constexpr cca::link_inertia base{5, {0, 0, 0.05}, {0.03, 0.03, 0.02, 0, 0, 0}};
};

// A trunk that may float, with the arm on it and a hip beside; no joints are coupled.
struct on_trunk : cca::serial_chain<trunk, arm_base, cca::axes<>> {
  static constexpr std::array<cca::joint, 0> joints{};
  static constexpr auto tip = at(0.1, 0.05, 0.1) * turned_about({1, 1, 0}, 0.7);
};
struct star_of_arms : cca::body<trunk,
                                cca::part<"place", on_trunk>,
                                cca::part<"arm", arm_chain>,
                                cca::part<"hip", hip_chain>> {
  static constexpr cca::link_inertia base{8, {0.01, 0, 0.02}, {0.1, 0.2, 0.2, 1e-3, 0, 0}};
};

}  // namespace body_test
