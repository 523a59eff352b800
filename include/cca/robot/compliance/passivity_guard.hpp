// The passivity guard: an energy tank between a controller and the robot. Whatever the controller does, the
// energy that its torques deliver is at most what the tank held plus what they have taken back.
//
//   cca::passivity_guard<Body, Angles, Velocities, Torques>
//     in  "torques"      Torques        N m (prismatic joints: N): what is guarded, without gravity
//     in  "angles"       Angles         measured, rad (prismatic: m)
//     in  "velocities"   Velocities     measured, rad/s
//     in  "gravity"      Torques        optional, N m: added unguarded, e.g. of gravity_compensation
//     out "torques"      Torques        N m, within the limits of its axes
//     out "energy"       tank_energy    J: what the tank holds
//     out "status"       input_status_port
//     out "guard"        guard_port     enum guard: passing, limiting
//
//   cca::node<"guard", cca::passivity_guard<arm, angles, velocities, torques>, cca::timed<1>>
//
// Constant springs and dampers never need it: what a spring delivers it has taken before. A stiffness that a
// learner modulates, a reference that moves, feed-forward and force control can feed a motion for ever: they
// may do so until the tank is empty. Then the torques are scaled down to the share that delivers nothing
// more (energy_tank.hpp), and the rest is replaced by a brake, -braking M dq. Torques that brake pass, and
// fill the tank again up to `most`. So choose `energy` (J at the start) for the work of the task: lifting,
// accelerating, the springs that it tenses.
//
// Let gravity compensation go around it: its work is that of a potential, so it can't add up. Give the
// controller `compensate_gravity = false`. Put the limiter after it, and choose limits that the robot can
// follow: the account is that of the torques that leave here.
//
// Parameters: `energy`, `most` in J; `braking` in 1/s, at most the rate of the node (checked on load).
//
// Inputs (input_status.hpp): while "angles" or "velocities" is NaN or infinite, the torque is "gravity", or 0
// where that is NaN too, and what flows into the tank doesn't count; while "torques" is, the torque is
// gravity and the brake. The status is `unreadable`. Until angles and velocities come, the torque is
// "gravity".
//
// Precondition: each coordinate moves mass. Errors: space.mismatch. Cost: mass matrix and its decomposition.
// Sources: energy_tank.hpp. Example: tests/runtime/compliance/passivity_guard.cpp; docs/compliance.md.
#pragma once

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
#include <cca/robot/compliance/energy_tank.hpp>
#include <cca/robot/dynamics/derived_mass.hpp>

namespace cca {

enum class guard : std::uint8_t {
  passing,  // the torques pass as they are
  limiting  // they are scaled down: the tank can't pay for them
};
struct guard_axis : dimension<"guard"> {};
struct guard_port : space<status, axes<guard_axis>> {};
struct tank_axis : dimension<"tank"> {};
struct tank_energy : space<number, axes<tank_axis>> {};  // J

template <class Type, class Angles, class Velocities, class Torques>
struct passivity_guard {
  using checked = std::void_t<decltype(detail::check_axes<Type, joint_angles, Angles>()),
                              decltype(detail::check_axes<Type, joint_velocities, Velocities>()),
                              decltype(detail::check_axes<Type, joint_torques, Torques>()),
                              decltype(detail::check_torques<Type, Torques>())>;
  using vector = typename body_pose<Type>::vector_type;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0, 1e9>, energy),
                             (cca::bounded<double, 0, 1e9>, most),
                             (cca::bounded<double, 0, 1000>, braking));
    parameters(double at_start = 2, double at_most = 2, double rate = 10)
        : energy(at_start), most(at_most), braking(rate) {}
    std::string_view check() const { return energy > most ? "`energy` is above `most`" : ""; }
    std::string check_at(double step) const {
      return detail::above_rate_bound("braking", braking, 1 / step, step);
    }
  };
  parameters p{};

  auto process(in<"torques", Torques> torques,
               in<"angles", Angles> angles,
               in<"velocities", Velocities> velocities,
               beat now,
               optional_in<"gravity", Torques> gravity,
               derived<mass_of<Type>, "angles"> moved = {}) -> std::tuple<out<"torques", Torques>,
                                                                          out<"energy", tank_energy>,
                                                                          out<"status", input_status_port>,
                                                                          out<"guard", guard_port>> {
    if (!begun) tank.start(p.energy);
    begun = true;
    detail::input_check motion, command, weight;
    const vector q = motion(of(angles)), dq = motion(of(velocities));
    const vector wanted = command(of(torques));
    vector held = vector::Zero();
    if (gravity) held = weight(of(gravity));
    if (weight.unreadable()) held.setZero();
    const auto status = status_of(detail::worse(motion.get(), detail::worse(command.get(), weight.get())));
    const bool blind = motion.unreadable() || angles.origin() == never || velocities.origin() == never;
    double share = 0;
    vector guarded = vector::Zero();
    if (blind) {
      gap = true;
    } else {
      if (gap) tank.draw_after_gap(q, p.most);
      else tank.draw(q, p.most);
      gap = false;
      const auto& [mass, solver] = detail::within_bounds(moved, angles, motion);
      const vector brake = -p.braking * math::product(mass, dq);
      if (!command.unreadable()) share = tank.share(wanted, vector(vector::Zero()), dq, solver, now.dt());
      // The brake takes the place of what does not pass.
      if (share < 1 && !command.unreadable())
        share = tank.share(vector(wanted - brake), brake, dq, solver, now.dt());
      guarded = command.unreadable() ? brake : vector(share * wanted + (1 - share) * brake);
    }
    bool cut = false;
    const typename Torques::vector_type within = detail::within_torque_limits<Torques>(
        detail::reordered<order, Torques>::to(vector(guarded + held)), cut);
    if (!blind) tank.hold(cut ? vector(of_torques(within) - held) : guarded, q);
    const bool limits = share < 1 && !blind;
    if (limits) [[unlikely]]
      ++limited;
    return {within, tank.joule(), status, status_of(limits ? guard::limiting : guard::passing)};
  }

  void on_start() {
    begun = gap = false;
    limited = 0;
  }
  std::string summary() const {
    return limited == 0 ? ""
                        : std::to_string(limited) + " times torques were held back to keep the robot passive";
  }

private:
  using order = axes_of<Type>;

  template <class Port>
  static vector of(const Port& port) {
    return detail::reordered<order, typename Port::space>::from(port.vector());
  }
  static vector of_torques(const typename Torques::vector_type& t) {
    return detail::reordered<order, Torques>::from(t);
  }

  detail::energy_tank<body_pose<Type>::size> tank;
  bool begun = false, gap = false;
  std::int64_t limited = 0;
};
template <class Type, class Angles, class Velocities, class Torques>
  requires(!Body<Type>)
struct passivity_guard<Type, Angles, Velocities, Torques>
    : passivity_guard<typename detail::body_or_refused<Type>::type, Angles, Velocities, Torques> {};

}  // namespace cca
