// A discrete movement primitive of a pose as a component: position and orientation share one phase, so they
// arrive together.
//
//   cca::node<"reach", cca::dmp_pose<hand_in_trunk, hand, 20>, cca::timed<1>>      20 basis functions
//
//   in  "goal"       S                  where the movement ends; may change during the movement
//   in  "start"      S                  optional: where it begins; else the zero of S
//   in  "duration"   movement_duration  s, optional: else the parameter; at least 1 ms; may change
//   in  "restart"    restart_signal     optional: each sample restarts the movement at the current pose
//   out "pose"       S                  maybe; its quaternion has unit length
//   out "velocity"   twist_of<S, Tip>   maybe; rad/s and m/s of the origin of Tip, along the axes of Frame
//   out "progress"   movement_progress  maybe; the canonical variable: 1 at the start, e^-decay at the end
//   out "status"     ode_status_port
//
// S is a space of pose<Frame>; Tip is the frame that moves. The parameter `weights` has six rows: three for
// the position, three for the rotation vector. If "start" is wired, the component waits for its first sample
// and publishes only its status until then.
//
// Inputs (input_status.hpp): as of dmp_discrete. While one is NaN or infinite, the movement stands still, the
// velocity is 0, nothing else is published, and the status is `unreadable`. What is too large for the
// component or too fast for the rate of the node is cut, with the status `clamped`.
//
// Errors: none. Cost: four derivatives, each with N + 1 exponentials, three arc tangents and three square
// roots; up to 16 times as much while max(stiffness / 2, goal_rate, decay) * dt > duration.
// Source: equations/dmp_pose_ode.hpp. Example: tests/runtime/motor/dmp_pose.cpp.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <tuple>

#include <cca/base/math/reductions.hpp>
#include <cca/component/input_status.hpp>
#include <cca/adaptive/ode_solver.hpp>
#include <cca/adaptive/ode_status.hpp>
#include <cca/adaptive/numerics/rate_bound.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/motor/equations/dmp_pose_ode.hpp>
#include <cca/motor/spaces.hpp>

namespace cca {

// The velocity of the frame Tip in the frame of a pose.
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
    parameters(const weight_matrix& shape = weight_matrix::Zero(),
               double seconds = 1,
               double stiff = 25,
               double decays = 5,
               double goal_follows = 12.5,
               bool scales = true,
               const ode_settling& settles = {1e-3, 1e-2})
        : weights(shape),
          duration(seconds),
          stiffness(stiff),
          decay(decays),
          goal_rate(goal_follows),
          scaled(scales),
          settling(settles) {}
    std::string_view check() const { return detail::too_large(weights, "a weight is above 1e12"); }
    std::string check_at(double step) const {
      return detail::below_rate_bound(
          "duration", duration,
          std::max({stiffness / 2, goal_rate.value(), decay.value()}) / detail::rate_bound(step), step);
    }
  };
  parameters p{};

  auto process(in<"goal", S> goal,
               optional_in<"start", S> start,
               optional_in<"duration", movement_duration> duration,
               optional_in<"restart", restart_signal> restart,
               beat now) -> std::tuple<maybe<"pose", S>,
                                       maybe<"velocity", twist_of<S, Tip>>,
                                       maybe<"progress", movement_progress>,
                                       out<"status", ode_status_port>> {
    detail::input_check inputs;
    const typename ode::pose to = inputs(goal.vector());
    const double tau =
        inputs.number(duration ? duration[duration_axis{}] : p.duration.value(), 1e-3, largest_input);
    typename twist_of<S, Tip>::vector_type velocity = twist_of<S, Tip>::vector_type::Zero();
    if (inputs.unreadable() || (!begun && start && !detail::has_come(start))) {
      maybe<"velocity", twist_of<S, Tip>> still;
      if (begun) still = velocity;
      return {{}, still, {}, status_of(inputs.get(), status.get())};
    }
    typename ode::state x = solver.get();
    if (!begun) {
      from = start ? inputs(start.vector()) : typename ode::pose(sample<S>{}.vector());
      x = ode::at_rest(from, to);
      begun = true;
    } else if (restart && restart.fresh()) {
      from << inputs(x.template head<3>()), x.template segment<4>(6);
      x.template segment<7>(13) = to;
      x[20] = 1;
      x = ode::project(x);
    }
    const typename ode::parameters at{p.weights, p.stiffness, p.decay, p.goal_rate, p.scaled};
    typename ode::input u;
    u << to, from, tau;
    solver.set(x);
    if (!solver.advance(u, at, now.dt())) inputs.note_clamped();
    x = solver.get();
    const double rate = math::norm(solver.rate(u, at));
    typename ode::pose pose;
    pose << x.template head<3>(), x.template segment<4>(6);
    velocity << x.template segment<3>(10), x.template segment<3>(3);
    velocity /= tau;
    return {pose, velocity, x[20], status_of(inputs.get(), status.update(rate, p.settling))};
  }

  // The next movement begins at "start".
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
