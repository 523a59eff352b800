// Hybrid control of force and position: along some axes the end of a part exerts a force, along the others it
// is a spring and a damper about a reference.
//
//   cca::hybrid_control<Body, "part", Angles, Velocities, Torques, Attitude>
//     in  "reference"    pose_in<Base>        the end, and the axes of the task: those of its orientation
//     in  "wanted"       load_on<Tip, Tip>    N m, N that the end exerts, along the axes of the reference
//     in  "measured"     load_on<Tip, Base>   N m, N: on the end, of a force sensor
//     in  "angles"       Angles               measured, rad (prismatic joints: m)
//     in  "velocities"   Velocities           measured, rad/s
//     in  "attitude"     Attitude             optional: orientation of the base, z up
//     out "torques"      Torques              N m, within the limits of its axes
//     out "exerted"      load_on<Tip, Tip>    N m, N along the axes of the reference: -measured, to watch
//     out "status"       input_status_port
//     out "saturation"   saturation_port      spring: a force is at `most_force`
//
// Base is the frame of the base of the body, Tip the frame in which the part ends. `force` chooses the axes
// with a force, of six: about x, y, z, then along x, y, z. For each of them
//
//   e = wanted - exerted,  u = wanted + proportional e + I - force_damping v,  cut to `most_force`
//   I' = integral e, |I| at most `most_integral`; I stands still while u is cut and e pulls it farther out
//
// The others get spring and damper as in cartesian_impedance.hpp. Joints that the end leaves free are damped.
// In the air the end approaches with at most (wanted (1 + proportional) + most_integral) / force_damping m/s.
// Where the contact is lost for good, change to another mode.
//
// Parameters: `force` (6 bools); `proportional`, `integral` in 1/s; `force_damping` (6: N m s, N s/m),
// `most_integral` and `most_force` (6: N m, N); `stiffness`, `damping_ratio`, `largest` as of
// cartesian_impedance; `posture_damping` in 1/s; `gravity` in m/s^2.
// An integral can feed a motion: put a `passivity_guard` after it.
//
// Inputs (input_status.hpp): while "angles", "velocities" or "attitude" is NaN or infinite, the torque is 0,
// or the nearest that the limits allow. While only another one is, forces and springs are left out: dampers
// and gravity compensation remain. The integral is frozen and the status is `unreadable`. Until a first
// "reference" comes only dampers and gravity compensation act; until angles and velocities come, the torque
// is 0.
//
// Preconditions: each coordinate moves mass. Errors: space.mismatch, frame.mismatch. Cost: that of
// cartesian_impedance.hpp. Sources: Raibert and Craig, Hybrid Position/Force Control of Manipulators, J.
// Dynamic Systems, Measurement, and Control 102, 1981 (selection per axis); Khatib 1987
// (operational_space.hpp); Astrom and Hagglund, PID Controllers, 1995, section 3.5 (no wind-up: conditional
// integration). Example: tests/runtime/compliance/hybrid_control.cpp; docs/compliance.md.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <tuple>

#include <cca/base/math/reductions.hpp>
#include <cca/adaptive/numerics/rate_bound.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/robot/body_components.hpp>
#include <cca/robot/compliance/cartesian_spring.hpp>
#include <cca/robot/compliance/damping_design.hpp>
#include <cca/robot/compliance/tip_dynamics.hpp>

namespace cca {

template <class Type,
          fixed_string Part,
          class Angles,
          class Velocities,
          class Torques,
          class Attitude = base_attitude>
struct hybrid_control {
  using checked = std::void_t<decltype(detail::check_axes<Type, joint_angles, Angles>()),
                              decltype(detail::check_axes<Type, joint_velocities, Velocities>()),
                              decltype(detail::check_axes<Type, joint_torques, Torques>()),
                              decltype(detail::check_torques<Type, Torques>())>;
  using base = typename Type::base_frame;
  using tip = tip_of<Type, Part>;
  using vector = typename body_pose<Type>::vector_type;
  using vector_6 = Eigen::Matrix<double, 6, 1>;

  struct parameters {
    using six_bools = std::array<bool, 6>;
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (six_bools, force),
                             (cca::bounded<double, 0, 1000>, proportional),
                             (cca::bounded<double, 0, 100000>, integral),
                             (vector_6, force_damping),
                             (vector_6, most_integral),
                             (vector_6, most_force),
                             (vector_6, stiffness),
                             (cca::bounded<double, 0, 10>, damping_ratio),
                             (vector_6, largest),
                             (cca::bounded<double, 0, 1000>, posture_damping),
                             (double, gravity));
    parameters()
        : force{false, false, false, false, false, true},
          proportional(0.5),
          integral(5),
          damping_ratio(0.7),
          largest(vector_6::Constant(1e30)),
          posture_damping(5),
          gravity(9.81) {
      force_damping << 2, 2, 2, 100, 100, 100;
      most_integral << 1, 1, 1, 10, 10, 10;
      most_force << 5, 5, 5, 50, 50, 50;
      stiffness << 30, 30, 30, 500, 500, 500;
    }
    std::string_view check() const {
      if (force_damping.minCoeff() < 0 || stiffness.minCoeff() < 0)
        return "a damping or stiffness is negative";
      if (most_force.minCoeff() < 0 || most_integral.minCoeff() < 0 || largest.minCoeff() < 0)
        return "a largest force or torque is negative";
      if (force_damping.maxCoeff() > largest_input || stiffness.maxCoeff() > largest_input ||
          most_force.maxCoeff() > largest_input || most_integral.maxCoeff() > largest_input)
        return "a damping, stiffness or force is above 1e12";
      return std::abs(gravity) <= 1e6 ? std::string_view() : "`gravity` is above 1e6 m/s^2";
    }
    std::string check_at(double step) const {
      return detail::above_rate_bound("posture_damping", posture_damping, 1 / step, step);
    }
  };
  parameters p{};

  auto process(in<"reference", pose_in<base>> reference,
               in<"wanted", load_on<tip, tip>> wanted,
               in<"measured", load_on<tip, base>> measured,
               in<"angles", Angles> angles,
               in<"velocities", Velocities> velocities,
               beat beat_now,
               optional_in<"attitude", Attitude> attitude,
               derived<pose_of<Type>, "angles"> pose = {},
               derived<end_of<Type, Part>, "angles"> end = {},
               derived<jacobian_of<Type, Part>, "angles"> jacobian = {},
               derived<mass_of<Type>, "angles"> mass = {}) -> std::tuple<out<"torques", Torques>,
                                                                         out<"exerted", load_on<tip, tip>>,
                                                                         out<"status", input_status_port>,
                                                                         out<"saturation", saturation_port>> {
    detail::input_check motion, wish;
    motion(of(angles));
    const vector dq = motion(of(velocities));
    detail::vector3 down{0, 0, -p.gravity};
    if (attitude)
      down = rotation::rotate(
          rotation::inverse(rotation::normalised(detail::vector4(motion(attitude.vector())))), down);
    Eigen::Matrix<double, 7, 1> goal = wish(reference.vector());
    goal.template tail<4>() = rotation::normalised(detail::vector4(goal.template tail<4>()));
    const vector_6 force = wish(wanted.vector()), load = wish(measured.vector());
    const bool acts = !wish.unreadable() && reference.origin() != never;
    const matrix3 frame =
        acts ? rotation::matrix(detail::vector4(goal.template tail<4>())) : matrix3(matrix3::Identity());
    vector_6 exerted = vector_6::Zero();
    if (acts) exerted = -turned(frame.transpose(), load);

    vector torques = vector::Zero();
    bool force_cut = false, torque_cut = false;
    if (!motion.unreadable() && angles.origin() != never && velocities.origin() != never) {
      const detail::tip_dynamics<Type, Part> at(detail::within_bounds(end, angles, motion),
                                                detail::within_bounds(jacobian, angles, motion),
                                                detail::within_bounds(mass, angles, motion));
      const vector_6 twist = math::product(at.jacobian, dq), local = turned(frame.transpose(), twist);
      const vector_6 chosen = selection(), k = p.stiffness.cwiseProduct(vector_6(vector_6::Ones() - chosen));
      vector_6 wrench = -math::product(
          detail::damping_for<6>(at.mobility, detail::root_along(frame, k), p.damping_ratio), twist);
      vector_6 u = -chosen.cwiseProduct(p.force_damping.cwiseProduct(local));
      if (acts) {
        wrench += detail::cartesian_spring(at.end, goal, frame, k, p.largest).wrench;
        u = controlled(chosen, force, exerted, u, beat_now.dt(), force_cut);
      }
      torques = math::product(at.jacobian.transpose(), wrench + turned(frame, u)) -
                p.posture_damping * at.free_momentum(dq) +
                gravity_torques(detail::within_bounds(pose, angles, motion), down);
    }
    const typename Torques::vector_type within =
        detail::within_torque_limits<Torques>(detail::reordered<order, Torques>::to(torques), torque_cut);
    const input_status inputs = detail::worse(motion.get(), wish.get());
    const saturation cut = torque_cut  ? saturation::torque
                           : force_cut ? saturation::spring
                                       : saturation::none;
    counts.note(inputs, cut);
    return {within, exerted, status_of(inputs), status_of(cut)};
  }

  void on_start() {
    integrated.setZero();
    counts = {};
  }
  std::string summary() const { return counts.summary(); }

private:
  using order = axes_of<Type>;

  template <class Port>
  static vector of(const Port& port) {
    return detail::reordered<order, typename Port::space>::from(port.vector());
  }
  static vector_6 turned(const matrix3& by, const vector_6& v) {
    return detail::spatial(math::product(by, detail::angular(v)), math::product(by, detail::linear(v)));
  }
  vector_6 selection() const {
    vector_6 chosen;
    for (int i = 0; i < 6; ++i) chosen[i] = p.force[static_cast<std::size_t>(i)] ? 1 : 0;
    return chosen;
  }

  // PI about the wanted force, on top of a damper.
  vector_6 controlled(const vector_6& chosen,
                      const vector_6& force,
                      const vector_6& exerted,
                      const vector_6& damper,
                      double dt,
                      bool& cut) {
    const vector_6 e = force - exerted;
    const vector_6 u = chosen.cwiseProduct(force + p.proportional * e + integrated) + damper;
    const vector_6 within = u.cwiseMin(p.most_force).cwiseMax(-p.most_force);
    cut = within != u;
    for (int i = 0; i < 6; ++i)
      if ((u[i] - within[i]) * e[i] <= 0)
        integrated[i] = chosen[i] * std::clamp(integrated[i] + dt * p.integral * e[i], -p.most_integral[i],
                                               p.most_integral[i]);
    return within;
  }

  vector_6 integrated = vector_6::Zero();
  detail::compliance_counts counts{};
};
template <class Type, fixed_string Part, class Angles, class Velocities, class Torques, class Attitude>
  requires(!Body<Type>)
struct hybrid_control<Type, Part, Angles, Velocities, Torques, Attitude>
    : hybrid_control<typename detail::body_or_refused<Type>::type,
                     Part,
                     Angles,
                     Velocities,
                     Torques,
                     Attitude> {};

}  // namespace cca
