// Four coupled oscillators, one per leg, that lock into a gait.
//
//   cca::node<"cpg", cca::gait_network<left_front, right_front, left_hind, right_hind>, cca::timed<1>>
//
//   in  "amplitude"  over<amplitude, legs>  >= 0
//   in  "frequency"  over<frequency, legs>  Hz, optional: else the parameter, for all legs
//   in  "gait"       gait_choice            a number of enum gait, optional: else the parameter
//   out "phase"      over<phase, legs>      rad in [0, 2 pi)
//   out "amplitude"  over<amplitude, legs>
//   out "status"     ode_status_port        converged once phases are locked and amplitudes are steady
//
// A change of gait moves leg i by i times the parameter `nudge` (0.06 degrees by default). Reason: half of
// the phase differences may have to change by exactly pi. There the coupling is zero, so without a nudge the
// legs would stay at this unstable equilibrium. The coupling is proportional to the amplitude: legs with
// amplitude 0 do not act on others. Precondition: all legs have the same frequency, or frequencies close
// enough for the coupling to lock.
//
// Inputs (input_status.hpp): while one is NaN or infinite, the state stands still, phases and amplitudes stay
// and the status is `unreadable`; beyond 1e12, and an amplitude below 0, it is cut and the status is
// `clamped`. So is a coupling or a convergence that is too stiff for the rate of the node: coupling times the
// sum of the amplitudes, and convergence / 2, are at most 16 / dt.
//
// Errors: an unknown number at "gait" means walk. Cost: 60 sines per beat (RK4); up to 16 times as much while
// coupling times the sum of the amplitudes, or convergence / 2, is above 1 / dt. Source:
// equations/oscillator_network_ode.hpp, gait.hpp. Example: tests/runtime/motor/gait_network.cpp.
#pragma once

#include <algorithm>
#include <string>
#include <tuple>

#include <cca/base/math/reductions.hpp>
#include <cca/component/input_status.hpp>
#include <cca/adaptive/ode_solver.hpp>
#include <cca/adaptive/ode_status.hpp>
#include <cca/adaptive/numerics/rate_bound.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/motor/gait.hpp>
#include <cca/motor/equations/oscillator_network_ode.hpp>
#include <cca/motor/spaces.hpp>

namespace cca {

template <class LeftFront, class RightFront, class LeftHind, class RightHind, class Integrator = rk4>
struct gait_network {
  using ode = oscillator_network_ode<4>;
  template <class Domain>
  using legs = over<Domain, LeftFront, RightFront, LeftHind, RightHind>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::gait, gait),
                             (cca::quantity<cca::frequency, 0, 100>, frequency),
                             (bounded<double, 0, 1000>, coupling),     // w, 1/s
                             (bounded<double, 0, 1000>, convergence),  // a, 1/s
                             (bounded<double, 0, 1>, nudge),           // rad
                             (ode_settling, settling));
    parameters(cca::gait which = cca::gait::trot,
               double turns_per_second = 1,
               double coupled = 4,
               double converges = 20,
               double nudged = 1e-3,
               const ode_settling& settles = {0.02, 0.05})
        : gait(which),
          frequency(turns_per_second),
          coupling(coupled),
          convergence(converges),
          nudge(nudged),
          settling(settles) {}
    // With amplitudes of 1.
    std::string check_at(double step) const {
      const double most = detail::rate_bound(step);
      const auto text = detail::above_rate_bound("coupling", coupling, most / 4, step);
      return text.empty() ? detail::above_rate_bound("convergence", convergence, 2 * most, step) : text;
    }
  };
  parameters p{};

  using result = std::tuple<out<"phase", legs<cca::phase>>,
                            out<"amplitude", legs<cca::amplitude>>,
                            out<"status", ode_status_port>>;

  auto process(in<"amplitude", legs<cca::amplitude>> wanted,
               optional_in<"frequency", legs<cca::frequency>> turns,
               optional_in<"gait", gait_choice> choice,
               beat now) -> result {
    detail::input_check inputs;
    ode::input u;
    if (turns) u.template head<4>() = inputs(turns.vector());
    else u.template head<4>().setConstant(p.frequency);
    for (int i = 0; i < 4; ++i) u[4 + i] = inputs.number(wanted.vector()[i], 0, largest_input);
    if (choice) inputs.number(choice.vector()[0]);
    ode::state x = solver.get();
    if (inputs.unreadable()) return published(x, inputs.get());
    const cca::gait next = choice ? choice.template as<cca::gait>() : p.gait;
    if (!begun) start(x, next);
    else if (next != current) change(x, next);
    // What the most parts of a step can follow.
    const double most = detail::rate_bound(now.dt()), pull = ode::radii(x, u);
    const double coupling = pull * p.coupling > most ? most / pull : p.coupling.value();
    at.weights.setConstant(coupling);
    at.weights.diagonal().setZero();
    at.convergence = std::min(p.convergence.value(), 2 * most);
    if (coupling < p.coupling || at.convergence < p.convergence) inputs.note_clamped();
    solver.set(x);
    if (!solver.advance(u, at, now.dt())) inputs.note_clamped();
    x = solver.get();
    for (int i = 0; i < 4; ++i) x[i] = wrap_turn(x[i]);
    solver.set(x);
    ode::state rate = solver.rate(u, at);
    rate.template head<4>().array() -= math::mean(rate.template head<4>());
    status.update(math::norm(rate), p.settling);
    return published(x, inputs.get());
  }

  // Begins with amplitude 0 and the phases of the gait.
  void on_start() {
    begun = false;
    status = {};
  }

private:
  result published(const ode::state& x, input_status inputs) const {
    return {x.template head<4>().eval(), x.template segment<4>(4).eval(), status_of(inputs, status.get())};
  }
  void start(ode::state& x, cca::gait which) {
    const auto phases = gait_phases(which);
    x.setZero();
    for (int i = 0; i < 4; ++i) x[i] = phases[static_cast<std::size_t>(i)];
    begun = true;
    current = which;
    at.phases = phase_matrix(which);
  }
  void change(ode::state& x, cca::gait which) {
    for (int i = 0; i < 4; ++i) x[i] += i * p.nudge;
    current = which;
    at.phases = phase_matrix(which);
  }

  ode_solver<ode, Integrator> solver;
  ode_monitor status;
  ode::parameters at{};
  cca::gait current{};
  bool begun = false;
};

}  // namespace cca
