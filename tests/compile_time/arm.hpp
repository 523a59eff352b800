#pragma once
// A user's arm of six joints, as cca-urdf writes it from a public description
// (tests/runtime/urdf/robots/ur5e.urdf): its hand goes around in a circle, by inverse kinematics, gravity
// compensation and an impedance.
#include <array>
#include <cmath>

#include <cca/cca.hpp>
#include <cca/mapping/inverse_kinematics.hpp>
#include <cca/robot/body_components.hpp>
#include <cca/robot/compliance/joint_impedance.hpp>
#include <cca/robot/limiter.hpp>
#include <cca/robot/watchdog.hpp>
#include <cca/sim/robot.hpp>

#include "ur5e.hpp"

namespace circling {

struct description : ur5e::description {
  static constexpr std::array start{0.0, -1.2, 1.8, -0.6, 1.57, 0.0};
};
using body = description::body;
using angles = cca::robots::angles<description>;
using velocities = cca::robots::velocities<description>;
using torques = cca::robots::torques<description>;
using hand = cca::pose_in<ur5e::frame::base_link>;

// A circle in the y-z plane, around the place where the hand began.
struct circle {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0.0, 0.3>, radius),    // m
                             (cca::bounded<double, 0.5, 60.0>, period));  // s
  };
  parameters p{0.1, 4.0};

  auto process(cca::in<"measured", hand> at, cca::beat now) -> cca::maybe<"target", hand> {
    if (at.origin() == cca::never) return {};
    if (!has_begun) begin = at.vector(), has_begun = true, since = now.time();
    const double angle = 2 * cca::pi * 1e-9 * static_cast<double>(now.time() - since) / p.period;
    hand::vector_type to = begin;
    to[1] += p.radius * std::sin(angle);
    to[2] += p.radius * (1 - std::cos(angle));
    return to;
  }
  void on_start() { has_begun = false; }

private:
  hand::vector_type begin = hand::vector_type::Zero();
  bool has_begun = false;
  std::int64_t since = 0;
};

struct servo : cca::joint_impedance<body, angles, velocities, torques> {
  servo() { p.compensate_gravity = false; }
};

template <class Robot>
struct architecture
    : cca::graph<
          cca::rate<1000>,
          cca::node<"robot", Robot>,
          cca::node<"hand", cca::part_kinematics<body, "wrist_3_link", angles, hand>>,
          cca::node<"circle", circle, cca::timed<1>>,
          cca::node<"ik", cca::inverse_kinematics<ur5e::wrist_3_link_chain, angles, hand>, cca::timed<1>>,
          cca::node<"gravity", cca::gravity_compensation<body, angles, torques>>,
          cca::node<"servo", servo, cca::timed<1>>,
          cca::node<"watchdog", cca::watchdog<torques, 5>>,
          cca::node<"limits", cca::limiter<torques>>,
          cca::wire<"robot.angles", "hand.angles">,
          cca::wire<"hand.pose", "circle.measured">,
          cca::wire<"circle.target", "ik.pose">,
          cca::wire<"robot.angles", "ik.near">,
          cca::wire<"robot.angles", "gravity.angles">,
          cca::wire<"ik.angles", "servo.reference">,
          cca::wire<"robot.angles", "servo.angles">,
          cca::wire<"robot.velocities", "servo.velocities">,
          cca::wire<"gravity.torques", "servo.feedforward">,
          cca::wire<"servo.torques", "watchdog.command">,
          cca::wire<"watchdog.fresh", "limits.command">,
          cca::wire<"limits.safe", "robot.torque">> {};

struct simulated : architecture<cca::sim::robot<description>> {};

}  // namespace circling
