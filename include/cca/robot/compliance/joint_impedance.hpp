// Joint impedance: each joint is a spring and a damper about a reference, on top of gravity compensation.
//
//   cca::joint_impedance<Body, Angles, Velocities, Torques, Attitude>
//     in  "reference"             Angles                    rad (prismatic joints: m)
//     in  "angles"                Angles                    measured
//     in  "velocities"            Velocities                measured, rad/s
//     in  "reference_velocities"  Velocities                optional: the damper acts on the difference
//     in  "stiffness"             stiffness_along<Torques>  optional, N m/rad: else the parameter
//     in  "damping"               damping_along<Torques>    optional, N m s/rad: else the parameter
//     in  "feedforward"           Torques                   optional, N m: added
//     in  "attitude"              Attitude                  optional: orientation of the base, z up
//     out "torques"               Torques                   N m, within the limits of its axes
//     out "status"                input_status_port
//     out "saturation"            saturation_port
//
// Without "reference_velocities" they are 0.
//
//   torques = spring + D (reference velocities - velocities) + feedforward + gravity
//   spring = stiffness (reference - angles), each axis cut to `largest`; along a continuous axis the
//   difference is the shortest way around the circle
//   D = diag(damping) + the damping that gives each mode `damping_ratio` (damping_design.hpp)
//
// Parameters: `stiffness`, `damping` and `largest` over axes_of<Body>; `damping_ratio` (0: only `damping`);
// `compensate_gravity` and `gravity` in m/s^2. Where it holds a known load, give its torque to
// "feedforward".
//
// With a constant stiffness and reference it creates no energy in continuous time, also where the spring is
// cut; feed-forward and a stiffness that changes can: put a `passivity_guard` after it.
//
// In a loop that runs every dt, what acts once a beat must be slow enough for the inertia that it moves:
// 2 M - dt (D + dt K) positive definite (beat_stability.hpp). It is checked on load and on changes in the
// middle of the axes' limits, and in each beat where the body is: while it does not hold, stiffness and
// damping are lowered, by s^2 and s, with the status `clamped`.
//
// Inputs (input_status.hpp): while "angles", "velocities" or "attitude" is NaN or infinite, the torque is 0,
// or the nearest that the limits allow. While only another one is, spring and feed-forward are left out: the
// damper of the parameters and gravity compensation remain. In both cases the status is `unreadable`. It has
// no state. Until a first "reference" comes there is no spring; until angles and velocities come, the torque
// is 0. A negative stiffness or damping counts as 0, with the status `clamped`.
//
// A function call without a beat, in a test, checks nothing of the loop.
//
// Precondition: each coordinate moves mass, if `damping_ratio` is not 0.
// Errors: space.mismatch. Cost: mass matrix, gravity torques, a small decomposition of n x n, and a large one
// unless `damping_ratio` is 0. Source: Ott, Cartesian Impedance Control of Redundant and Flexible-Joint
// Robots, 2008, chapter 3. Example: tests/runtime/compliance/joint_impedance.cpp; docs/compliance.md.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <tuple>

#include <cca/base/math/reductions.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/robot/body_components.hpp>
#include <cca/robot/compliance/beat_stability.hpp>
#include <cca/robot/compliance/compliance_spaces.hpp>
#include <cca/robot/compliance/damping_design.hpp>
#include <cca/robot/dynamics/mass_matrix.hpp>
#include <cca/base/math/positive_matrix.hpp>
#include <cca/space/methods/circle.hpp>

namespace cca {

template <class Type, class Angles, class Velocities, class Torques, class Attitude = base_attitude>
struct joint_impedance {
  using checked = std::void_t<decltype(detail::check_axes<Type, joint_angles, Angles>()),
                              decltype(detail::check_axes<Type, joint_velocities, Velocities>()),
                              decltype(detail::check_axes<Type, joint_torques, Torques>()),
                              decltype(detail::check_torques<Type, Torques>())>;
  using vector = typename body_pose<Type>::vector_type;
  using matrix = Eigen::Matrix<double, body_pose<Type>::size, body_pose<Type>::size>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (vector, stiffness),
                             (vector, damping),
                             (cca::bounded<double, 0, 10>, damping_ratio),
                             (vector, largest),
                             (bool, compensate_gravity),
                             (double, gravity));
    parameters(const vector& n_m_per_rad = vector::Constant(50),
               const vector& n_m_s_per_rad = vector::Zero(),
               double ratio = 0.7,
               const vector& n_m = vector::Constant(1e30),
               bool compensates = true,
               double m_s2 = 9.81)
        : stiffness(n_m_per_rad),
          damping(n_m_s_per_rad),
          damping_ratio(ratio),
          largest(n_m),
          compensate_gravity(compensates),
          gravity(m_s2) {}
    std::string_view check() const {
      if (stiffness.minCoeff() < 0) return "a stiffness is negative";
      if (damping.minCoeff() < 0) return "a damping is negative";
      if (largest.minCoeff() < 0) return "`largest` is negative";
      if (stiffness.maxCoeff() > largest_input || damping.maxCoeff() > largest_input)
        return "a stiffness or damping is above 1e12";
      return std::abs(gravity) <= 1e6 ? std::string_view() : "`gravity` is above 1e6 m/s^2";
    }
    std::string check_at(double step) const {
      const body_pose<Type> now(detail::middle_of(axes_of<Type>()));
      const matrix mass = mass_matrix(now);
      const matrix all = resistance(mass, stiffness, damping, damping_ratio);
      const double share =
          detail::stable_share<body_pose<Type>::size>(mass, all, stiffness.asDiagonal(), step);
      if (share == 1) return "";
      int worst = 0;
      const vector speed = (all.diagonal() + step * stiffness).cwiseQuotient(mass.diagonal());
      speed.maxCoeff(&worst);
      return detail::beyond_beat(names[static_cast<std::size_t>(worst)], stiffness[worst], all(worst, worst),
                                 share, step);
    }
  };
  parameters p{};

  auto process(in<"reference", Angles> reference,
               in<"angles", Angles> angles,
               in<"velocities", Velocities> velocities,
               optional_in<"reference_velocities", Velocities> reference_velocities,
               optional_in<"stiffness", stiffness_along<Torques>> stiffness,
               optional_in<"damping", damping_along<Torques>> damping,
               optional_in<"feedforward", Torques> feedforward,
               optional_in<"attitude", Attitude> attitude,
               beat this_beat = beat{0, 0, 1},
               derived<pose_of<Type>, "angles"> pose = {}) -> std::
      tuple<out<"torques", Torques>, out<"status", input_status_port>, out<"saturation", saturation_port>> {
    detail::input_check motion, wish;
    const vector q = motion(of(angles)), dq = motion(of(velocities));
    detail::vector3 down{0, 0, -p.gravity};
    if (attitude)
      down = rotation::rotate(
          rotation::inverse(rotation::normalised(detail::vector4(motion(attitude.vector())))), down);
    const vector wanted = wish(of(reference));
    vector k = p.stiffness, d = p.damping, dq_wanted = vector::Zero(), added = vector::Zero();
    if (reference_velocities) dq_wanted = wish(of(reference_velocities));
    if (stiffness) k = detail::at_least_zero(wish, of(stiffness));
    if (damping) d = detail::at_least_zero(wish, of(damping));
    if (feedforward) added = wish(of(feedforward));

    vector torques = vector::Zero();
    bool spring_cut = false, torque_cut = false;
    if (!motion.unreadable() && angles.origin() != never && velocities.origin() != never) {
      if (wish.unreadable()) k = p.stiffness, d = p.damping, dq_wanted.setZero(), added.setZero();
      const body_pose<Type>& now = detail::within_bounds(pose, angles, motion);
      const matrix mass = mass_matrix(now);
      matrix resists = resistance(mass, k, d, p.damping_ratio);
      const double share =
          detail::stable_share<body_pose<Type>::size>(mass, resists, k.asDiagonal(), this_beat.dt());
      if (share < 1) [[unlikely]] {
        wish.note_clamped();
        resists *= share;
        k *= share * share;
      }
      torques = added + math::product(resists, dq_wanted - dq);
      if (!wish.unreadable() && reference.origin() != never) {
        const vector pull =
                         k.cwiseProduct(detail::shortest_way<detail::limits_along<order, angle>>(q, wanted)),
                     cut = pull.cwiseMin(p.largest).cwiseMax(-p.largest);
        spring_cut = cut != pull;
        torques += cut;
      }
      if (p.compensate_gravity) torques += gravity_torques(now, down);
    }
    const typename Torques::vector_type within =
        detail::within_torque_limits<Torques>(detail::reordered<order, Torques>::to(torques), torque_cut);
    const input_status inputs = detail::worse(motion.get(), wish.get());
    const saturation cut = torque_cut   ? saturation::torque
                           : spring_cut ? saturation::spring
                                        : saturation::none;
    counts.note(inputs, cut);
    return {within, status_of(inputs), status_of(cut)};
  }

  void on_start() { counts = {}; }
  std::string summary() const { return counts.summary(); }

private:
  using order = axes_of<Type>;

  template <class Port>
  static vector of(const Port& port) {
    return detail::reordered<order, typename Port::space>::from(port.vector());
  }

  static constexpr std::array names = []<class... Axes>(axes<Axes...>) {
    return std::array{Axes::label.view()...};
  }(order());

  // All damping: of each axis, and what gives each mode the ratio.
  static matrix resistance(const matrix& mass, const vector& k, const vector& d, double ratio) {
    matrix all = d.asDiagonal();
    if (ratio == 0) return all;
    const matrix root = k.cwiseSqrt().asDiagonal();
    const matrix mobility =
        detail::positive_matrix<body_pose<Type>::size>(mass).solve(matrix(matrix::Identity()));
    all += detail::damping_for<body_pose<Type>::size>(mobility, root, ratio);
    return all;
  }

  detail::compliance_counts counts{};
};
template <class Type, class Angles, class Velocities, class Torques, class Attitude>
  requires(!Body<Type>)
struct joint_impedance<Type, Angles, Velocities, Torques, Attitude>
    : joint_impedance<typename detail::body_or_refused<Type>::type, Angles, Velocities, Torques, Attitude> {};

}  // namespace cca
