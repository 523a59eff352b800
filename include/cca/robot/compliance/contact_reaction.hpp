// Contact: detects from the external torques of a momentum observer that something touches the arm, and
// reacts until it lets go.
//
//   cca::contact_reaction<Body, Angles, Velocities, Torques, Attitude>
//     in  "torques"      Torques        N m (prismatic joints: N): the command, with gravity compensation
//     in  "external"     Torques        N m, of momentum_observer
//     in  "angles"       Angles         measured, rad (prismatic: m)
//     in  "velocities"   Velocities     measured, rad/s
//     in  "attitude"     Attitude       optional: orientation of the base, z up
//     out "torques"      Torques        N m, within the limits of its axes
//     out "contact"      contact_port   enum contact: none, reacting, returning
//     out "status"       input_status_port
//
//   none        the command passes; to `reacting` when some |external| is above `threshold` for `confirm` s
//   reacting    as `reaction` says; to `returning` when all are below half of it for `release` s
//   returning   within `back` s from the reaction to the command; a new contact begins again
//
//   enum reaction   torques
//   stop            gravity + stop_stiffness (angles at the contact - angles) - D dq
//   yield           gravity - braking M dq: the arm floats and can be pushed away
//   follow          gravity + gain external - braking M dq: it goes along, 1 + gain times lighter
//
// D gives each mode of the stiffness the damping ratio 0.7 (damping_design.hpp).
//
// Parameters: `threshold` over axes_of<Body> in N m, above what friction and errors of the model cause;
// `confirm`, `release`, `back` in s; `reaction`; `stop_stiffness` over axes_of<Body>; `gain`; `braking` in
// 1/s, at most the rate of the node (checked on load); `gravity` in m/s^2.
//
// "external" must not contain the reaction: the observer takes the torques that leave here (or the limiter
// after), over `delayed<1>`. `follow` gives energy; put a `passivity_guard` after it.
//
// Inputs (input_status.hpp): while "angles", "velocities" or "attitude" is NaN or infinite, the torque is 0,
// or the nearest that the limits allow; while only "external" or "torques" is, the arm yields. The status is
// `unreadable`, and the state and its times stand still. Until angles and velocities come, the command
// passes.
//
// Precondition: each coordinate moves mass, for the brake to act on it. Errors: space.mismatch. Cost: in a
// contact gravity torques and the momentum of the joints; `stop` a decomposition of n x n. Source: De Luca,
// Albu-Schaeffer, Haddadin, Hirzinger, Collision Detection and Safe Reaction with the DLR-III Lightweight
// Manipulator Arm, IROS 2006; Haddadin, De Luca, Albu-Schaeffer, Robot Collisions: A Survey on Detection,
// Isolation, and Identification, IEEE Trans. Robotics 33(6), 2017. Example:
// tests/runtime/compliance/contact_reaction.cpp; docs/compliance.md.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>

#include <cca/base/math/reductions.hpp>
#include <cca/adaptive/numerics/rate_bound.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/robot/body_components.hpp>
#include <cca/robot/compliance/compliance_spaces.hpp>
#include <cca/robot/compliance/damping_design.hpp>
#include <cca/robot/dynamics/mass_matrix.hpp>
#include <cca/robot/dynamics/momentum.hpp>
#include <cca/base/math/positive_matrix.hpp>

namespace cca {

enum class contact : std::uint8_t { none, reacting, returning };
enum class reaction : std::uint8_t { stop, yield, follow };
struct contact_axis : dimension<"contact"> {};
struct contact_port : space<status, axes<contact_axis>> {};

template <class Type, class Angles, class Velocities, class Torques, class Attitude = base_attitude>
struct contact_reaction {
  using checked = std::void_t<decltype(detail::check_axes<Type, joint_angles, Angles>()),
                              decltype(detail::check_axes<Type, joint_velocities, Velocities>()),
                              decltype(detail::check_axes<Type, joint_torques, Torques>()),
                              decltype(detail::check_torques<Type, Torques>())>;
  using vector = typename body_pose<Type>::vector_type;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (vector, threshold),
                             (cca::quantity<cca::duration, 0, 1000>, confirm),
                             (cca::quantity<cca::duration, 0, 1000>, release),
                             (cca::quantity<cca::duration, 0, 1000>, back),
                             (cca::reaction, reaction),
                             (vector, stop_stiffness),
                             (cca::bounded<double, 0, 10>, gain),
                             (cca::bounded<double, 0, 1000>, braking),
                             (double, gravity));
    parameters()
        : threshold(vector::Constant(5)),
          confirm(0.002),
          release(0.5),
          back(1),
          reaction(cca::reaction::yield),
          stop_stiffness(vector::Constant(50)),
          gain(1),
          braking(10),
          gravity(9.81) {}
    std::string_view check() const {
      if (threshold.minCoeff() <= 0) return "a threshold is not above 0";
      if (stop_stiffness.minCoeff() < 0) return "a stiffness is negative";
      if (stop_stiffness.maxCoeff() > largest_input) return "a stiffness is above 1e12";
      return std::abs(gravity) <= 1e6 ? std::string_view() : "`gravity` is above 1e6 m/s^2";
    }
    std::string check_at(double step) const {
      return detail::above_rate_bound("braking", braking, 1 / step, step);
    }
  };
  parameters p{};

  auto process(in<"torques", Torques> torques,
               in<"external", Torques> external,
               in<"angles", Angles> angles,
               in<"velocities", Velocities> velocities,
               beat beat_now,
               optional_in<"attitude", Attitude> attitude)
      -> std::tuple<out<"torques", Torques>, out<"contact", contact_port>, out<"status", input_status_port>> {
    detail::input_check motion, others;
    const vector q = motion(of(angles)), dq = motion(of(velocities));
    detail::vector3 down{0, 0, -p.gravity};
    if (attitude)
      down = rotation::rotate(
          rotation::inverse(rotation::normalised(detail::vector4(motion(attitude.vector())))), down);
    const vector command = others(of(torques)), push = others(of(external));
    const bool has_come = angles.origin() != never && velocities.origin() != never;
    vector result = command;
    if (motion.unreadable()) {
      result.setZero();
    } else if (has_come) {
      if (!others.unreadable()) go_on(push, q, beat_now.dt());
      if (state != contact::none || others.unreadable()) {
        const body_pose<Type> at(q);
        const vector floating = gravity_torques(at, down) - p.braking * joint_momentum(at, dq).momentum;
        result = others.unreadable() ? floating : blended(floating + reaction_to(at, push, q, dq), command);
      }
    } else if (others.unreadable()) {
      result.setZero();
    }
    bool cut = false;
    return {detail::within_torque_limits<Torques>(detail::reordered<order, Torques>::to(result), cut),
            status_of(state), status_of(detail::worse(motion.get(), others.get()))};
  }

  void on_start() {
    state = contact::none;
    for_s = 0;
  }

private:
  using order = axes_of<Type>;

  template <class Port>
  static vector of(const Port& port) {
    return detail::reordered<order, typename Port::space>::from(port.vector());
  }

  void go_on(const vector& push, const vector& q, double dt) {
    const bool touched = (push.array().abs() > p.threshold.array()).any();
    const bool free = (push.array().abs() < 0.5 * p.threshold.array()).all();
    // For how long what would end the state has been true; of `returning`, its age.
    const bool counts = state == contact::reacting ? free : state == contact::returning || touched;
    for_s = counts ? std::min(for_s + dt, 1e6) : 0;
    if (state == contact::reacting) {
      if (free && for_s >= p.release) state = contact::returning, for_s = 0;
    } else if (touched && (state == contact::returning || for_s >= p.confirm)) {
      state = contact::reacting, for_s = 0;
      at_contact = q;
    } else if (state == contact::returning && for_s >= p.back) {
      state = contact::none, for_s = 0;
    }
  }

  vector reaction_to(const body_pose<Type>& at, const vector& push, const vector& q, const vector& dq) const {
    if (p.reaction == reaction::follow) return p.gain * push;
    if (p.reaction == reaction::yield) return vector::Zero();
    using matrix = Eigen::Matrix<double, body_pose<Type>::size, body_pose<Type>::size>;
    const matrix root = p.stop_stiffness.cwiseSqrt().asDiagonal(),
                 mobility = detail::positive_matrix<body_pose<Type>::size>(mass_matrix(at))
                                .solve(matrix(matrix::Identity()));
    return p.stop_stiffness.cwiseProduct(at_contact - q) -
           math::product(detail::damping_for<body_pose<Type>::size>(mobility, root, 0.7), dq);
  }

  vector blended(const vector& reaction, const vector& command) const {
    if (state != contact::returning) return reaction;
    const double share = std::min(1.0, for_s / std::max<double>(p.back, 1e-9));
    return (1 - share) * reaction + share * command;
  }

  contact state = contact::none;
  double for_s = 0;
  vector at_contact = vector::Zero();
};
template <class Type, class Angles, class Velocities, class Torques, class Attitude>
  requires(!Body<Type>)
struct contact_reaction<Type, Angles, Velocities, Torques, Attitude>
    : contact_reaction<typename detail::body_or_refused<Type>::type, Angles, Velocities, Torques, Attitude> {
};

}  // namespace cca
