// Tutorial, step 7: an adaptive module. docs/tutorial/7_adaptive.md
#pragma once

#include <string>

#include <cca/adaptive/ode_solver.hpp>
#include <cca/adaptive/ode_status.hpp>
#include <cca/adaptive/recursive_least_squares.hpp>
#include <cca/adaptive/training.hpp>
#include <cca/base/math.hpp>

#include "leg_spaces.hpp"

// [ode]
// x' = rate (goal - x): the target moves smoothly to the goal.
struct approach {
  using state = Eigen::Vector2d;
  using input = Eigen::Vector2d;
  struct parameters {
    double rate;
  };
  static state derivative(const state& x, const input& goal, const parameters& p) {
    return p.rate * (goal - x);
  }
  static state initial() { return {0, -0.5}; }
};
// [ode end]

// [model]
// The currents that hold a posture: linear in the sines of the segments' angles.
struct weight_of_leg {
  using input = Eigen::Vector2d;   // hip, knee in rad
  using output = Eigen::Vector2d;  // hip, knee in A
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (Eigen::Matrix2d, weights));
    parameters() : weights(Eigen::Matrix2d::Zero()) {}
  };
  static Eigen::Vector2d regressors(const input& q) {
    return {cca::math::sin(q[0]), cca::math::sin(q[0] + q[1])};
  }
  static output answer(const parameters& p, const input& q) { return p.weights * regressors(q); }
  static std::string title() { return "weight of a leg over hip, knee"; }
};
// [model end]

// [module]
// Moves the leg to a goal like `impedance`, and learns the currents that carry its weight.
//
//   in  reference   leg_target          the goal
//   in  feedback    leg_angles          measured
//   in  velocities  leg_velocities      measured
//   out command     leg_currents        for the motors
//   out ode         ode_status_port     has the target arrived at the goal?
//   out module      module_status_port  what the learner does, and whether this posture was learned
struct holding {
  using learner = cca::recursive_least_squares<weight_of_leg>;
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0.0, 100.0>, stiffness),  // A/rad
                             (cca::bounded<double, 0.0, 5.0>, damping),      // A s/rad
                             (cca::bounded<double, 0.1, 20.0>, rate),        // of the approach, 1/s
                             (cca::ode_settling, settling),
                             (learner::settings, settings));
  };
  parameters p{20.0, 1.0, 5.0, {}, {}};

  auto process(cca::in<"reference", leg_target> goal,
               cca::in<"feedback", leg_angles> angles,
               cca::in<"velocities", leg_velocities> velocities,
               cca::beat now) -> std::tuple<cca::out<"command", leg_currents>,
                                            cca::out<"ode", cca::ode_status_port>,
                                            cca::out<"module", cca::module_status_port>> {
    const approach::parameters speed{p.rate};
    target.advance(goal.vector(), speed, now.dt());
    const Eigen::Vector2d q = angles.vector(), v = velocities.vector();
    const Eigen::Vector2d currents = p.stiffness * (target.get() - q) - p.damping * v + learning.answer(q);
    if (v.norm() < 1e-3) learning.teach(q, currents, p.settings);  // at rest they carry the weight exactly
    return {currents, cca::status_of(monitor.update(target.rate(goal.vector(), speed).norm(), p.settling)),
            learning.status(q, p.settings)};
  }

  cca::training<learner> learning;

private:
  cca::ode_solver<approach, cca::rk4> target;
  cca::ode_monitor monitor;
};
// [module end]
