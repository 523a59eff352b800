// Admittance: a wrench in, a motion out. The end of a robot that follows positions moves like a mass on a
// spring and a damper.
//
//   cca::node<"give", cca::admittance<arm_base, flange>, cca::timed<1>>
//
//   cca::admittance<Frame, Tip>
//     in  "reference"     pose_in<Frame>            where the spring pulls to, and the limits count from
//     in  "wrench"        load_on<Tip, Frame>       N m, N: measured, on the end
//     in  "feedforward"   load_on<Tip, Frame>       optional: added
//     in  "stiffness"     stiffness_at<Tip, Frame>  optional, N m/rad, N/m: else the parameter
//     in  "damping"       damping_at<Tip, Frame>    optional, N m s/rad, N s/m: else the parameter
//     out "pose"          pose_in<Frame>            where the end should be
//     out "twist"         motion_of<Tip, Frame>     rad/s, m/s
//     out "status"        input_status_port
//     out "saturation"    saturation_port           motion: at `fastest` or `farthest`
//
//   mass v' + damping v + stiffness (pose - reference) = wrench + feedforward,  pose' = v
//
// six axes of Frame, first about, then along them. By the backward Euler rule: it is stable for every mass,
// damping, stiffness and rate, and takes from the wrench at least the energy that it stores.
//
// What can be unstable is the contact: the wrench answers a motion that is `lag` (of the robot that follows)
// and a beat old. Parameter `contact` is the stiffness of the stiffest thing that it touches; then
//
//   damping >= contact (lag + step)
//
// is enough for every mass, and checked on load and on changes. A damping from the port is raised to it, with
// the status `clamped`.
//
// Parameters (6 numbers each): `mass` in kg m^2 and kg, `damping`, `stiffness`, `contact` in N m/rad and N/m,
// `fastest` in rad/s and m/s, `farthest` from the reference in rad (at most 3) and m; `lag` in s.
//
// Inputs (input_status.hpp): while one is NaN or infinite, the pose stands still, the twist that it publishes
// is 0 and the status is `unreadable`; then it goes on as before. It begins at the first reference at rest,
// and publishes the zero of its spaces until then.
//
// Errors: frame.mismatch. Cost: about 200 operations. Sources: Hogan, Impedance Control: An Approach to
// Manipulation, J. Dynamic Systems, Measurement, and Control 107, 1985; Keemink, van der Kooij, Stienen,
// Admittance Control for Physical Human-Robot Interaction, Int. J. Robotics Research 37(11), 2018 (limits by
// the stiffness that it touches). Example: tests/runtime/compliance/admittance.cpp; docs/compliance.md.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <tuple>

#include <cca/adaptive/numerics/rate_bound.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/robot/compliance/cartesian_spring.hpp>
#include <cca/robot/compliance/compliance_spaces.hpp>

namespace cca {

template <class Frame, class Tip>
struct admittance {
  using vector_6 = Eigen::Matrix<double, 6, 1>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (vector_6, mass),
                             (vector_6, damping),
                             (vector_6, stiffness),
                             (vector_6, contact),
                             (cca::quantity<cca::duration, 0, 10>, lag),
                             (vector_6, fastest),
                             (vector_6, farthest));
    parameters() : stiffness(vector_6::Zero()), lag(0) {
      mass << 0.1, 0.1, 0.1, 5, 5, 5;
      damping << 2, 2, 2, 100, 100, 100;
      contact << 20, 20, 20, 1000, 1000, 1000;
      fastest << 1, 1, 1, 0.5, 0.5, 0.5;
      farthest << 1, 1, 1, 0.5, 0.5, 0.5;
    }
    std::string_view check() const {
      if (mass.minCoeff() < 1e-6) return "a mass is below 1e-6";
      if (damping.minCoeff() < 0 || stiffness.minCoeff() < 0 || contact.minCoeff() < 0)
        return "a damping or stiffness is negative";
      if (fastest.minCoeff() < 0 || farthest.minCoeff() < 0) return "a limit is negative";
      if (farthest.template head<3>().maxCoeff() > 3) return "`farthest` is above 3 rad";
      for (const vector_6* each : {&mass, &damping, &stiffness, &contact, &fastest, &farthest})
        if (each->maxCoeff() > largest_input) return "a number is above 1e12";
      return "";
    }
    std::string check_at(double step) const {
      for (int i = 0; i < 6; ++i)
        if (auto what = detail::below_rate_bound("damping", damping[i], least_damping(step)[i], step);
            !what.empty())
          return what;
      return "";
    }
    vector_6 least_damping(double step) const { return (lag + step) * contact; }
  };
  parameters p{};

  auto process(in<"reference", pose_in<Frame>> reference,
               in<"wrench", load_on<Tip, Frame>> wrench,
               beat now,
               optional_in<"feedforward", load_on<Tip, Frame>> feedforward,
               optional_in<"stiffness", stiffness_at<Tip, Frame>> stiffness,
               optional_in<"damping", damping_at<Tip, Frame>> damping)
      -> std::tuple<out<"pose", pose_in<Frame>>,
                    out<"twist", motion_of<Tip, Frame>>,
                    out<"status", input_status_port>,
                    out<"saturation", saturation_port>> {
    detail::input_check inputs;
    pose_vector goal = inputs(reference.vector());
    goal.template tail<4>() = rotation::normalised(detail::vector4(goal.template tail<4>()));
    vector_6 load = inputs(wrench.vector()), k = p.stiffness, d = p.damping;
    if (feedforward) load += inputs(feedforward.vector());
    if (stiffness) k = detail::at_least_zero(inputs, stiffness.vector());
    if (damping) {
      const vector_6 least = p.least_damping(now.dt());
      for (int i = 0; i < 6; ++i) d[i] = inputs.number(damping.vector()[i], least[i]);
    }
    bool cut = false;
    vector_6 velocity = vector_6::Zero();
    if (!inputs.unreadable() && reference.origin() != never) {
      if (!begun) pose = goal;
      begun = true;
      advance(goal, load, k, d, now.dt(), cut);
      velocity = twist;
    }
    const saturation limited = cut ? saturation::motion : saturation::none;
    counts.note(inputs.get(), limited);
    return {pose, velocity, status_of(inputs.get()), status_of(limited)};
  }

  std::string summary() const { return counts.summary(); }

  void on_start() {
    counts = {};
    begun = false;
    twist.setZero();
    pose = sample<pose_in<Frame>>{}.vector();
  }

private:
  using pose_vector = Eigen::Matrix<double, 7, 1>;

  // The displacement from the reference: a rotation vector, then a vector.
  vector_6 away_from(const pose_vector& goal) const {
    return detail::spatial(detail::turn_from(goal.tail<4>(), pose.tail<4>()),
                           pose.head<3>() - goal.head<3>());
  }

  void advance(const pose_vector& goal,
               const vector_6& load,
               const vector_6& k,
               const vector_6& d,
               double dt,
               bool& cut) {
    const vector_6 away = away_from(goal), pull = -k.cwiseProduct(away);
    const vector_6 spring =
        detail::spatial(detail::torque_of_gradient(away.head<3>(), pull.head<3>()), pull.tail<3>());
    for (int i = 0; i < 6; ++i)
      twist[i] =
          (p.mass[i] * twist[i] + dt * (load[i] + spring[i])) / (p.mass[i] + dt * d[i] + dt * dt * k[i]);
    cut = limit(twist, p.fastest);
    pose.head<3>() += dt * twist.tail<3>();
    pose.tail<4>() = rotation::normalised(rotation::product(
        rotation::exp(detail::vector3(dt * twist.head<3>())), detail::vector4(pose.tail<4>())));
    vector_6 farther = away_from(goal);
    const vector_6 before = farther;
    if (!limit(farther, p.farthest)) return;
    cut = true;
    for (int i = 0; i < 6; ++i)
      if (farther[i] != before[i] && twist[i] * before[i] > 0) twist[i] = 0;
    pose.head<3>() = goal.head<3>() + farther.tail<3>();
    pose.tail<4>() =
        rotation::product(rotation::exp(detail::vector3(farther.head<3>())), detail::vector4(goal.tail<4>()));
  }

  static bool limit(vector_6& v, const vector_6& most) {
    const vector_6 within = v.cwiseMin(most).cwiseMax(-most);
    const bool changed = within != v;
    v = within;
    return changed;
  }

  pose_vector pose = sample<pose_in<Frame>>{}.vector();
  vector_6 twist = vector_6::Zero();
  bool begun = false;
  detail::compliance_counts counts{};
};

}  // namespace cca
