// A discrete movement primitive of a pose as a component: position and orientation arrive together, on one
// phase.
//
//   cca::node<"reach", cca::dmp_pose<hand_in_trunk, hand, 20>, cca::timed<1>>      20 basis functions; hand:
//   a frame in  "goal"        S, a space of pose<Frame>; may change while it runs in  "start"       S,
//   optional: where it begins; else the space's zero. Until a first sample has come there, it waits and
//                     publishes its status alone
//   in  "duration"    movement_duration, s, optional: else the parameter; may change while it runs; at least
//   1 ms in  "restart"     restart_signal, optional: each sample that arrives begins the movement anew, from
//   where it is out "pose"        S, a maybe, its quaternion of unit length out "velocity"    twist<Tip,
//   Frame>, a maybe: of Tip's origin, along Frame's axes out "progress"    movement_progress, a maybe out
//   "status"      ode_status_port
//
// Weights: six rows, of the position and of the rotation vector. Errors: none; while an input is not finite,
// it stays where it is and publishes its status alone. Cost: four derivatives of N + 1 exponentials, three
// arcus tangents and roots each. Source: dmp_pose_ode.hpp. Example: tests/runtime/motor/dmp_pose.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <tuple>

#include <cca/adaptive/ode_solver.hpp>
#include <cca/adaptive/ode_status.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/motor/equations/dmp_pose_ode.hpp>
#include <cca/motor/finite.hpp>
#include <cca/motor/spaces.hpp>

namespace cca {

// How a frame moves in that of a pose.
template <class PoseSpace, class Tip>
struct twist_of : space<twist<Tip, typename PoseSpace::domain::frame>, typename PoseSpace::axes> {};

template <Space S, class Tip, int N, class Integrator = rk4>
struct dmp_pose {
  using ode = dmp_pose_ode<N>;
  using weight_matrix = Eigen::Matrix<double, 6, N>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (weight_matrix, weights),
                             (cca::quantity<cca::duration, 0.001, 1000>, duration),
                             (bounded<double, 0.1, 1000>, stiffness),
                             (bounded<double, 0.1, 50>, decay),
                             (bounded<double, 0, 1000>, goal_rate),
                             (bool, scaled),
                             (ode_settling, settling));
  };
  parameters p{weight_matrix::Zero(), 1.0, 25.0, 5.0, 12.5, true, {1e-3, 1e-2}};

  auto process(in<"goal", S> goal,
               optional_in<"start", S> start,
               optional_in<"duration", movement_duration> duration,
               optional_in<"restart", restart_signal> restart,
               beat now) -> std::tuple<maybe<"pose", S>,
                                       maybe<"velocity", twist_of<S, Tip>>,
                                       maybe<"progress", movement_progress>,
                                       out<"status", ode_status_port>> {
    const double wanted = duration ? duration[duration_axis{}] : p.duration.value(),
                 tau = std::max(1e-3, wanted);
    if (!detail::all_finite(goal.vector()) || !std::isfinite(wanted) ||
        (!begun && start && !detail::has_come(start)))
      return {{}, {}, {}, status_of(status.get())};
    typename ode::state x = solver.get();
    if (!begun) {
      from = start ? start.vector() : sample<S>{}.vector();
      x = ode::at_rest(from, goal.vector());
      begun = true;
    } else if (restart && restart.fresh()) {
      from << x.template head<3>(), x.template segment<4>(6);
      x.template segment<7>(13) = goal.vector();
      x[20] = 1;
      x = ode::project(x);
    }
    const typename ode::parameters at{p.weights, p.stiffness, p.decay, p.goal_rate, p.scaled};
    typename ode::input u;
    u << goal.vector(), from, tau;
    solver.set(x);
    solver.advance(u, at, now.dt());
    x = solver.get();
    const double rate = solver.rate(u, at).norm();
    typename ode::pose pose;
    pose << x.template head<3>(), x.template segment<4>(6);
    typename twist_of<S, Tip>::vector_type velocity;
    velocity << x.template segment<3>(10), x.template segment<3>(3);
    velocity /= tau;
    return {pose, velocity, x[20], status_of(status.update(rate, p.settling))};
  }

  // Begins at "start" again.
  void on_start() {
    begun = false;
    status = {};
  }

private:
  ode_solver<ode, Integrator> solver;
  ode_monitor status;
  typename ode::pose from = ode::initial().template segment<7>(13);
  bool begun = false;
};

}  // namespace cca
