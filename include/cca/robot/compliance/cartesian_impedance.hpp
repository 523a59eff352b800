// Cartesian impedance: the end of a part is a spring and a damper about a reference pose, in position and
// orientation; the joints that it leaves free keep a posture.
//
//   cca::cartesian_impedance<Body, "part", Angles, Velocities, Torques, Along, Attitude>
//     in  "reference"        pose_in<Base>             where the end of the part should be
//     in  "angles"           Angles                    measured, rad (prismatic joints: m)
//     in  "velocities"       Velocities                measured, rad/s
//     in  "reference_twist"  motion_of<Tip, Base>      optional: the damper acts on the difference
//     in  "stiffness"        stiffness_at<Tip, Along>  optional, N m/rad, N/m: else the parameter
//     in  "damping"          damping_at<Tip, Along>    optional, N m s/rad, N s/m: else the parameter
//     in  "feedforward"      load_on<Tip, Base>        optional, N m, N: added to the wrench on the end
//     in  "posture"          Angles                    optional: what the free joints hold
//     in  "attitude"         Attitude                  optional: orientation of the base, z up
//     out "torques"          Torques                   N m, within the limits of its axes
//     out "wrench"           load_on<Tip, Base>        N m, N: spring, damper and feed-forward
//     out "status"           input_status_port
//     out "saturation"       saturation_port
//
// Without "reference_twist" it is 0; without "posture" the free joints are only damped.
//
// Base is the frame of the base of the body, Tip the frame in which the part ends. `Along` is the frame of
// the principal axes: Base, or Tip for the axes of the *reference*.
//
//   wrench = spring (cartesian_spring.hpp) + D (reference twist - twist) + feedforward
//   D = diag(damping) + the damping that gives each mode `damping_ratio` (damping_design.hpp)
//   torques = J^T wrench + N (posture stiffness (posture - angles)) - posture damping N M dq + gravity
//
// N is the dynamically consistent projection: the end is not accelerated by what the free joints do. Its
// damper can only dissipate. Its spring is projected, so it is no spring any more and could create energy on
// a cycle; a tank of `posture_energy` J pays for it (energy_tank.hpp), and when it is empty the posture
// yields.
//
// Parameters: `stiffness`, `damping` (6: about, then along the axes); `damping_ratio`; `largest` (6: torques
// and forces of the spring, each axis); `posture_stiffness` over axes_of<Body>, `posture_damping` in 1/s,
// `posture_energy` in J; `compensate_gravity`, `gravity` in m/s^2.
//
// In a loop that runs every dt, spring, dampers and posture must be slow enough for the inertia that they
// move (beat_stability.hpp). It is checked on load and on changes in the middle of the axes' limits, and in
// each beat where the body is: while it does not hold, stiffnesses and dampings are lowered, by s^2 and s,
// with the status `clamped`.
//
// With a constant stiffness and reference it creates no more energy than `posture_energy`; feed-forward and a
// stiffness that changes can: put a `passivity_guard` after it. Near a singular position the end is heavy in
// some direction and the torques stay finite.
//
// Inputs (input_status.hpp): while "angles", "velocities" or "attitude" is NaN or infinite, the torque is 0,
// or the nearest that the limits allow. While only another one is, spring, feed-forward and posture are left
// out: dampers and gravity compensation remain. In both cases the status is `unreadable`. Until a first
// "reference" comes there is no spring; until angles and velocities come, the torque is 0. A negative
// stiffness or damping counts as 0, with the status `clamped`.
//
// Preconditions: each coordinate moves mass; reference and end less than half a turn apart.
// Errors: space.mismatch, frame.mismatch. Cost: mass matrix, gravity torques, two decompositions of 6 x 6 and
// one of n x n. Sources: Ott, Cartesian Impedance Control of Redundant and Flexible-Joint Robots, 2008;
// Albu-Schaeffer et al., ICRA 2003 (damping_design.hpp); Dietrich, Ott, Stramigioli, Passivation of
// Projection-Based Null Space Compliance Control Via Energy Tanks, IEEE RA-L 1(1), 2016.
// Example: tests/runtime/compliance/cartesian_impedance.cpp; docs/compliance.md.
#pragma once

#include <string>
#include <string_view>
#include <tuple>

#include <cca/base/math/reductions.hpp>
#include <cca/adaptive/numerics/rate_bound.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/robot/body_components.hpp>
#include <cca/robot/compliance/beat_stability.hpp>
#include <cca/robot/compliance/cartesian_spring.hpp>
#include <cca/robot/compliance/damping_design.hpp>
#include <cca/robot/compliance/energy_tank.hpp>
#include <cca/robot/compliance/tip_dynamics.hpp>
#include <cca/space/methods/circle.hpp>

namespace cca {

namespace detail {
template <fixed_string Part, class Along, class Base, class Tip>
struct along_third_frame {
  static constexpr void tell(text& m) {
    m << "frame.mismatch: the principal axes of this Cartesian impedance of the part `" << Part.view()
      << "` are those of " << type_name<Along>() << ", but they are those of the base of the body, "
      << type_name<Base>() << ", or of the frame in which the part ends, " << type_name<Tip>();
  }
};
}  // namespace detail

template <class Type,
          fixed_string Part,
          class Angles,
          class Velocities,
          class Torques,
          class Along = typename detail::checked_body<Type>::base_frame,
          class Attitude = base_attitude>
struct cartesian_impedance {
  using checked = std::void_t<decltype(detail::check_axes<Type, joint_angles, Angles>()),
                              decltype(detail::check_axes<Type, joint_velocities, Velocities>()),
                              decltype(detail::check_axes<Type, joint_torques, Torques>()),
                              decltype(detail::check_torques<Type, Torques>())>;
  using base = typename Type::base_frame;
  using tip = tip_of<Type, Part>;
  static constexpr bool along_reference = std::is_same_v<Along, tip>;
  static_assert(detail::holds_or_tells<(along_reference || std::is_same_v<Along, base>),
                                       detail::along_third_frame<Part, Along, base, tip>>::value);
  using vector = typename body_pose<Type>::vector_type;
  using vector_6 = Eigen::Matrix<double, 6, 1>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (vector_6, stiffness),
                             (vector_6, damping),
                             (cca::bounded<double, 0, 10>, damping_ratio),
                             (vector_6, largest),
                             (vector, posture_stiffness),
                             (cca::bounded<double, 0, 1000>, posture_damping),
                             (cca::bounded<double, 0, 1000>, posture_energy),
                             (bool, compensate_gravity),
                             (double, gravity));
    parameters()
        : damping(vector_6::Zero()),
          damping_ratio(0.7),
          largest(vector_6::Constant(1e30)),
          posture_stiffness(vector::Constant(10)),
          posture_damping(5),
          posture_energy(2),
          compensate_gravity(true),
          gravity(9.81) {
      stiffness << 30, 30, 30, 500, 500, 500;
    }
    std::string_view check() const {
      if (stiffness.minCoeff() < 0 || posture_stiffness.minCoeff() < 0) return "a stiffness is negative";
      if (damping.minCoeff() < 0) return "a damping is negative";
      if (largest.minCoeff() < 0) return "`largest` is negative";
      if (stiffness.maxCoeff() > largest_input || posture_stiffness.maxCoeff() > largest_input ||
          damping.maxCoeff() > largest_input)
        return "a stiffness or damping is above 1e12";
      return std::abs(gravity) <= 1e6 ? std::string_view() : "`gravity` is above 1e6 m/s^2";
    }
    std::string check_at(double step) const {
      if (auto what = detail::above_rate_bound("posture_damping", posture_damping, 1 / step, step);
          !what.empty())
        return what;
      const detail::tip_dynamics_at<Type, Part> at(detail::middle_of(axes_of<Type>()));
      const matrix3 along = along_reference ? at.end.turn : matrix3(matrix3::Identity());
      const double share = share_of(at, all_damping(at, along, stiffness, damping, damping_ratio),
                                    spring_of(along, stiffness), posture_stiffness, step);
      if (share == 1) return "";
      return detail::rate_text("stiffness", stiffness.maxCoeff(), "at most",
                               share * share * stiffness.maxCoeff(), step) +
             "; with a lower `damping` or `posture_stiffness`, if that is what is large";
    }
  };
  parameters p{};

  auto process(in<"reference", pose_in<base>> reference,
               in<"angles", Angles> angles,
               in<"velocities", Velocities> velocities,
               beat beat_now,
               optional_in<"reference_twist", motion_of<tip, base>> reference_twist,
               optional_in<"stiffness", stiffness_at<tip, Along>> stiffness,
               optional_in<"damping", damping_at<tip, Along>> damping,
               optional_in<"feedforward", load_on<tip, base>> feedforward,
               optional_in<"posture", Angles> posture,
               optional_in<"attitude", Attitude> attitude,
               derived<pose_of<Type>, "angles"> pose = {},
               derived<end_of<Type, Part>, "angles"> end = {},
               derived<jacobian_of<Type, Part>, "angles"> jacobian = {},
               derived<mass_of<Type>, "angles"> mass = {}) -> std::tuple<out<"torques", Torques>,
                                                                         out<"wrench", load_on<tip, base>>,
                                                                         out<"status", input_status_port>,
                                                                         out<"saturation", saturation_port>> {
    detail::input_check motion, wish;
    const vector q = motion(of(angles)), dq = motion(of(velocities));
    detail::vector3 down{0, 0, -p.gravity};
    if (attitude)
      down = rotation::rotate(
          rotation::inverse(rotation::normalised(detail::vector4(motion(attitude.vector())))), down);
    Eigen::Matrix<double, 7, 1> goal = wish(reference.vector());
    goal.template tail<4>() = rotation::normalised(detail::vector4(goal.template tail<4>()));
    vector_6 k = p.stiffness, d = p.damping, wanted_twist = vector_6::Zero(), added = vector_6::Zero();
    vector rest = vector::Zero();
    if (reference_twist) wanted_twist = wish(reference_twist.vector());
    if (stiffness) k = detail::at_least_zero(wish, stiffness.vector());
    if (damping) d = detail::at_least_zero(wish, damping.vector());
    if (feedforward) added = wish(feedforward.vector());
    if (posture) rest = wish(of(posture));

    vector torques = vector::Zero();
    vector_6 wrench = vector_6::Zero();
    bool spring_cut = false, torque_cut = false;
    if (!motion.unreadable() && angles.origin() != never && velocities.origin() != never) {
      const bool pulls = !wish.unreadable() && reference.origin() != never;
      if (wish.unreadable()) {
        k = p.stiffness, d = p.damping, wanted_twist.setZero(), added.setZero();
        goal << 0, 0, 0, 0, 0, 0, 1;
      }
      const detail::tip_dynamics<Type, Part> at(detail::within_bounds(end, angles, motion),
                                                detail::within_bounds(jacobian, angles, motion),
                                                detail::within_bounds(mass, angles, motion));
      const matrix3 frame = along_reference ? rotation::matrix(detail::vector4(goal.template tail<4>()))
                                            : matrix3(matrix3::Identity());
      const vector_6 away = wanted_twist - math::product(at.jacobian, dq);
      detail::matrix6 resists = all_damping(at, frame, k, d, p.damping_ratio);
      vector posture_k = p.posture_stiffness;
      const double share = share_of(at, resists, spring_of(frame, k), posture_k, beat_now.dt());
      if (share < 1) [[unlikely]] {
        wish.note_clamped();
        resists *= share;
        k *= share * share, posture_k *= share * share;
      }
      wrench = added + math::product(resists, away);
      if (pulls) {
        const auto pull = detail::cartesian_spring(at.end, goal, frame, k, p.largest);
        spring_cut = pull.cut;
        wrench += pull.wrench;
      }
      vector spring = vector::Zero();
      if (posture && posture.origin() != never && !wish.unreadable())
        spring = at.free_torques(vector(
            posture_k.cwiseProduct(detail::shortest_way<detail::limits_along<order, angle>>(q, rest))));
      torques =
          math::product(at.jacobian.transpose(), wrench) + free_joints(at, spring, q, dq, beat_now.dt());
      if (p.compensate_gravity) torques += gravity_torques(detail::within_bounds(pose, angles, motion), down);
    } else {
      gap = true;
    }
    const typename Torques::vector_type within =
        detail::within_torque_limits<Torques>(detail::reordered<order, Torques>::to(torques), torque_cut);
    const input_status inputs = detail::worse(motion.get(), wish.get());
    const saturation cut = torque_cut   ? saturation::torque
                           : spring_cut ? saturation::spring
                                        : saturation::none;
    counts.note(inputs, cut);
    return {within, wrench, status_of(inputs), status_of(cut)};
  }

  void on_start() {
    begun = false;
    gap = false;
    tank.start(0);
    counts = {};
  }
  std::string summary() const { return counts.summary(); }

  // What the tank of the posture holds, in J.
  double posture_energy() const { return tank.joule(); }

private:
  using order = axes_of<Type>;

  template <class Port>
  static vector of(const Port& port) {
    return detail::reordered<order, typename Port::space>::from(port.vector());
  }

  // About and along the axes of the base.
  static detail::matrix6 spring_of(const matrix3& frame, const vector_6& k) {
    const detail::matrix6 root = detail::root_along(frame, k);
    return math::product(root, root.transpose());
  }
  static detail::matrix6 all_damping(const detail::tip_dynamics<Type, Part>& at,
                                     const matrix3& frame,
                                     const vector_6& k,
                                     const vector_6& d,
                                     double ratio) {
    return spring_of(frame, d) + detail::damping_for<6>(at.mobility, detail::root_along(frame, k), ratio);
  }
  // In the joints (beat_stability.hpp).
  static double share_of(const detail::tip_dynamics<Type, Part>& at,
                         const detail::matrix6& damping,
                         const detail::matrix6& spring,
                         const vector& posture,
                         double dt) {
    using matrix = Eigen::Matrix<double, body_pose<Type>::size, body_pose<Type>::size>;
    const matrix d = math::product(math::product(at.jacobian.transpose(), damping), at.jacobian);
    matrix k = math::product(math::product(at.jacobian.transpose(), spring), at.jacobian);
    k += posture.asDiagonal();
    return detail::stable_share<body_pose<Type>::size, false>(at.mass, d, k, dt);
  }

  // The torques of the posture, of which the tank pays the spring.
  vector free_joints(const detail::tip_dynamics<Type, Part>& at,
                     const vector& spring,
                     const vector& q,
                     const vector& dq,
                     double dt) {
    const vector damper = -p.posture_damping * at.free_momentum(dq);
    if (!begun) tank.start(p.posture_energy);
    if (gap) tank.draw_after_gap(q, p.posture_energy);
    else tank.draw(q, p.posture_energy);
    begun = true, gap = false;
    const vector all = damper + tank.share(spring, damper, dq, at.solver, dt) * spring;
    tank.hold(all, q);
    return all;
  }

  detail::energy_tank<body_pose<Type>::size> tank;
  bool begun = false, gap = false;
  detail::compliance_counts counts{};
};
template <class Type,
          fixed_string Part,
          class Angles,
          class Velocities,
          class Torques,
          class Along,
          class Attitude>
  requires(!Body<Type>)
struct cartesian_impedance<Type, Part, Angles, Velocities, Torques, Along, Attitude>
    : cartesian_impedance<typename detail::body_or_refused<Type>::type,
                          Part,
                          Angles,
                          Velocities,
                          Torques,
                          Along,
                          Attitude> {};

}  // namespace cca
