// External torques of a body from its generalised momentum: what pushes it beside its motors and gravity.
//
//   cca::momentum_observer<Body, Angles, Velocities, Torques, Attitude>
//     in  "angles"       Angles             rad (prismatic joints: m)
//     in  "velocities"   Velocities         rad/s
//     in  "torques"      Torques            N m (prismatic: N) of the motors since the last firing
//     in  "attitude"     Attitude           optional: orientation of the base in a world with z up
//     out "external"     Torques            N m; a wrench f on the end of a part appears as J^T f
//     out "status"       input_status_port
//
// "torques" are those that acted between the last firing and this one. Wire measured torques directly, and
// commanded ones with `cca::delayed<1>`. Friction that they don't contain counts as external.
// The base does not accelerate. Neither accelerations nor the inverse of the mass matrix are needed.
//
//   r' = 2 pi bandwidth (external - r), by r = 2 pi bandwidth (p - p(0) - integral of (torques + change -
//   gravity torques + r)); p and change: momentum.hpp
//
// The torques count as constant in a beat, `change` and gravity as linear (trapezoidal rule), and r by
// backward differences: every bandwidth is stable at every rate. A constant external torque is found exactly
// at rest; one that changes, with the lag of the filter. Parameters: `bandwidth` in Hz, `gravity` in
// m/s^2.
//
// Inputs (input_status.hpp): while one is NaN or infinite, "external" keeps its value; it goes on from there
// with the first two readable firings in a row, so a gap makes no step. Beyond 1e12 an input is cut.
//
// Source: De Luca and Mattone, Sensorless Robot Collision Detection and Hybrid Force/Motion Control, ICRA
// 2005; De Luca, Albu-Schaeffer, Haddadin, Hirzinger, Collision Detection and Safe Reaction with the DLR-III
// Lightweight Manipulator Arm, IROS 2006. Errors: space.mismatch. Cost: about that of inverse dynamics.
// Example: tests/runtime/body/momentum_observer.cpp.
#pragma once

#include <tuple>

#include <cca/component/beat.hpp>
#include <cca/component/input_status.hpp>
#include <cca/component/parameters.hpp>
#include <cca/robot/body_components.hpp>
#include <cca/robot/dynamics/momentum.hpp>

namespace cca {

template <class Type, class Angles, class Velocities, class Torques, class Attitude = base_attitude>
struct momentum_observer {
  using checked = std::void_t<decltype(detail::check_axes<Type, joint_angles, Angles>()),
                              decltype(detail::check_axes<Type, joint_velocities, Velocities>()),
                              decltype(detail::check_axes<Type, joint_torques, Torques>()),
                              decltype(detail::check_torques<Type, Torques>())>;
  using vector = typename body_pose<Type>::vector_type;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::frequency, 0.001, 100000>, bandwidth),
                             (double, gravity));
    parameters(double hz = 20, double m_s2 = 9.81) : bandwidth(hz), gravity(m_s2) {}
    std::string_view check() const {
      return std::abs(gravity) <= 1e6 ? std::string_view() : "`gravity` is above 1e6 m/s^2";
    }
  };
  parameters p{};

  auto process(in<"angles", Angles> angles,
               in<"velocities", Velocities> velocities,
               in<"torques", Torques> torques,
               beat now,
               optional_in<"attitude", Attitude> attitude,
               derived<pose_of<Type>, "angles"> pose = {})
      -> std::tuple<out<"external", Torques>, out<"status", input_status_port>> {
    using order = axes_of<Type>;
    detail::input_check inputs;
    inputs(detail::reordered<order, Angles>::from(angles.vector()));
    const vector dq = inputs(detail::reordered<order, Velocities>::from(velocities.vector())),
                 drive = inputs(detail::reordered<order, Torques>::from(torques.vector()));
    detail::vector3 down{0, 0, -p.gravity};
    if (attitude) {
      const detail::vector4 turn = inputs(attitude.vector());
      down = rotation::rotate(rotation::inverse(rotation::normalised(turn)), down);
    }
    if (inputs.unreadable()) {
      begun = false;
    } else {
      const body_pose<Type>& at = detail::within_bounds(pose, angles, inputs);
      const auto found = joint_momentum(at, dq);
      const vector load = found.change - gravity_torques(at, down);
      if (begun) {
        const double gain = 2 * pi * p.bandwidth, dt = now.dt();
        const vector gained = found.momentum - momentum - dt * (drive + 0.5 * (load + load_before));
        external = (external + gain * gained) / (1 + gain * dt);
      }
      momentum = found.momentum;
      load_before = load;
      begun = true;
    }
    return {detail::reordered<order, Torques>::to(external), status_of(inputs.get())};
  }

  void on_start() {
    begun = false;
    external.setZero();
  }

private:
  vector external = vector::Zero(), momentum = vector::Zero(), load_before = vector::Zero();
  bool begun = false;
};
template <class Type, class Angles, class Velocities, class Torques, class Attitude>
  requires(!Body<Type>)
struct momentum_observer<Type, Angles, Velocities, Torques, Attitude>
    : momentum_observer<typename detail::body_or_refused<Type>::type, Angles, Velocities, Torques, Attitude> {
};

}  // namespace cca
