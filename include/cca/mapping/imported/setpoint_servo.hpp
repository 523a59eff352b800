// The torque loop below a setpoint_blend: springs and dampers with the gains that come, at the robot's rate.
//
//   cca::setpoint_servo<angles, velocities, torques>       its node: cca::timed<1>
//
//   in  "target"      Angles     rad           of the blend
//   in  "stiffness"   setpoint_stiffness<Angles>
//   in  "damping"     setpoint_damping<Angles>
//   in  "angles"      Angles     measured, rad
//   in  "velocities"  Velocities measured, rad/s
//   out "torques"     Torques    N m: stiffness (target - angle) - damping velocity
//
// A joint whose angle or velocity is not finite, or older than `oldest`, loses spring or damper within
// `fade`, and gets it back as slowly; meanwhile its last good number counts. So no sensor that fails makes a
// torque jump. Torques are 0 until all have come. Errors: mapping.policy_numbers; component.bad_parameter.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include <cca/mapping/imported/setpoints.hpp>

namespace cca {

template <Space Angles, Space Velocities, Space Torques>
struct setpoint_servo {
  struct check {
    static constexpr bool holds = std::is_same_v<typename Angles::axes, typename Velocities::axes> &&
                                  std::is_same_v<typename Angles::axes, typename Torques::axes>;
    static constexpr void tell(detail::text& m) {
      m << "mapping.policy_numbers: angles, velocities and torques of a setpoint_servo are over other axes: "
           "give them one list of axes";
    }
  };
  static_assert(detail::holds_or_tells<check::holds, check>::value);

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::duration, 0, 10>, fade),
                             (cca::quantity<cca::duration, 0, 10>, oldest));
  };
  parameters p{0.1, 0.05};

  auto process(in<"target", Angles> target,
               in<"stiffness", setpoint_stiffness<Angles>> stiffness,
               in<"damping", setpoint_damping<Angles>> damping,
               in<"angles", Angles> angles,
               in<"velocities", Velocities> velocities,
               beat now) -> out<"torques", Torques> {
    typename Torques::vector_type torques = Torques::vector_type::Zero();
    if (!detail::has_come(target) || !detail::has_come(stiffness) || !detail::has_come(damping))
      return torques;
    const double step = p.fade > 0 ? now.dt() / p.fade : 1;
    const bool angles_are_new = is_new(angles, now), velocities_are_new = is_new(velocities, now);
    for (int i = 0; i < Angles::size; ++i) {
      reading &angle = angle_[static_cast<std::size_t>(i)],
              &velocity = velocity_[static_cast<std::size_t>(i)];
      angle.take(angles.vector()[i], angles_are_new, step);
      velocity.take(velocities.vector()[i], velocities_are_new, step);
      torques[i] = angle.trust * stiffness.vector()[i] * (target.vector()[i] - angle.good) -
                   velocity.trust * damping.vector()[i] * velocity.good;
    }
    return torques;
  }
  void on_start() { angle_ = {}, velocity_ = {}; }

private:
  struct reading {
    double good = 0, trust = 0;
    bool has_come = false;
    void take(double q, bool is_new, double step) {
      if (is_new && std::isfinite(q)) {
        trust = has_come ? std::min(1.0, trust + step) : 1;
        good = q;
        has_come = true;
      } else trust = std::max(0.0, trust - step);
    }
  };
  template <class Port>
  bool is_new(const Port& port, beat now) const {
    return port.origin() != never && static_cast<double>(now.time() - port.origin()) <= 1e9 * p.oldest;
  }

  std::array<reading, static_cast<std::size_t>(Angles::size)> angle_{}, velocity_{};
};

}  // namespace cca
