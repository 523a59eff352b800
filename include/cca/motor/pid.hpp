// A PID controller, each axis by itself.
//
//   cca::node<"servo", cca::pid<leg_angles, leg_torques>, cca::timed<1>>
//
//   in  "reference"    Measured                      the wanted value
//   in  "measured"     Measured
//   in  "manual"       Command                       optional: the command while "automatic" is 0
//   in  "automatic"    over<status, automatic_axis>  optional: 0 means manual
//   in  "velocity"     velocity_of<Measured>         optional: the wanted velocity; else 0
//   in  "feedforward"  Command                       optional: added to the command
//   out "command"      Command                       within the limits of its axes, and at most `largest`
//   out "status"       input_status_port
//
//   v = kp (r - y) + I + D + F,  u = v cut to the limits
//   I' = ki (r - y) + (u - v) / tracking        back-calculation: no wind-up
//   D  = kd (r' - y_f'),  filter y_f' = y - y_f   r' is "velocity": a step of the reference makes no kick
//   F is "feedforward"
//
// Along a continuous axis (space/dimension.hpp) r - y and y - y_f are the shortest way around the circle.
// With the velocity that a movement publishes (vite, dmp_discrete) and the torque that it needs
// (inverse_dynamics_of), the error need not be large to make the command. Measured and Command are spaces
// with one number per axis. Gains: unit of Command per unit of Measured (ki: and per s, kd: times s), at most
// 1e12; `filter` and `tracking` in s. The integral uses forward differences, the derivative backward ones:
// every filter time is stable. Transfers are bumpless: on a change from manual to automatic or of a gain the
// command continues without a jump. The difference decays through the integral or, with ki = 0, within the
// tracking time.
//
// Inputs (input_status.hpp): while one is NaN or infinite, the command is 0 (or the nearest that the limits
// allow) on all axes, the integral is frozen and the status is `unreadable`. By hand, a readable "manual" is
// followed even then. Beyond 1e12 an input is cut and the status is `clamped`.
//
// Errors: none. Cost: about 20 operations per axis. Source: Astrom and Murray, Feedback Systems, 2008,
// sections 10.4, 10.5; Astrom and Hagglund, PID Controllers, 1995, section 3.5.
// Example: tests/runtime/motor/pid.cpp.
#pragma once

#include <algorithm>
#include <string_view>
#include <tuple>

#include <cca/component/input_status.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/motor/spaces.hpp>
#include <cca/space/methods/circle.hpp>

namespace cca {

struct automatic_axis : dimension<"automatic"> {};

template <detail::LinearSpace Measured, detail::LinearSpace Command>
  requires(Measured::size == Command::size)
struct pid {
  using vector = Eigen::Matrix<double, Measured::size, 1>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (vector, proportional),
                             (vector, integral),
                             (vector, derivative),
                             (cca::quantity<cca::duration, 0, 100>, filter),
                             (cca::quantity<cca::duration, 0.001, 1000>, tracking),
                             (vector, largest));
    parameters(const vector& k_p = vector::Ones(),
               const vector& k_i = vector::Zero(),
               const vector& k_d = vector::Zero(),
               double filter_time = 0.01,
               double tracking_time = 0.1,
               const vector& most = vector::Constant(1e30))
        : proportional(k_p),
          integral(k_i),
          derivative(k_d),
          filter(filter_time),
          tracking(tracking_time),
          largest(most) {}
    std::string_view check() const {
      if (proportional.minCoeff() < 0 || integral.minCoeff() < 0 || derivative.minCoeff() < 0)
        return "a gain is negative";
      if (proportional.maxCoeff() > largest_input || integral.maxCoeff() > largest_input ||
          derivative.maxCoeff() > largest_input)
        return "a gain is above 1e12";
      return largest.minCoeff() < 0 ? "`largest` is negative" : "";
    }
  };
  parameters p{};

  auto process(in<"reference", Measured> reference,
               in<"measured", Measured> measured,
               optional_in<"manual", Command> manual,
               optional_in<"automatic", over<cca::status, automatic_axis>> automatic,
               beat now,
               optional_in<"velocity", velocity_of<Measured>> velocity = {},
               optional_in<"feedforward", Command> feedforward = {})
      -> std::tuple<out<"command", Command>, out<"status", input_status_port>> {
    const bool by_hand = manual && automatic && automatic[automatic_axis{}] == 0;
    detail::input_check inputs;
    vector hand = vector::Zero();
    if (by_hand) hand = inputs(manual.vector());
    const bool hand_is_readable = !inputs.unreadable();
    const vector y = inputs(measured.vector()), e = difference_of<Measured>(inputs(reference.vector()), y);
    vector speed = vector::Zero(), added = vector::Zero();
    if (velocity) speed = inputs(velocity.vector());
    if (feedforward) added = inputs(feedforward.vector());
    if (automatic) inputs.number(automatic[automatic_axis{}]);
    if (inputs.unreadable())
      return {limited(by_hand && hand_is_readable ? hand : vector(vector::Zero())), status_of(inputs.get())};
    if (!begun) {
      filtered = y;
      proportional = p.proportional, derivative = p.derivative;
      begun = true;
    }
    const double dt = now.dt();
    const vector slope = difference_of<Measured>(y, filtered) / (p.filter + dt), lag = speed - slope;
    filtered += dt * slope;
    integral +=
        (proportional - p.proportional).cwiseProduct(e) + (derivative - p.derivative).cwiseProduct(lag);
    proportional = p.proportional, derivative = p.derivative;

    const vector direct = proportional.cwiseProduct(e) + derivative.cwiseProduct(lag) + added;
    if (by_hand) {
      const vector command = limited(hand);
      integral = command - direct;
      return {command, status_of(inputs.get())};
    }
    const vector wanted = direct + integral, command = limited(wanted);
    const double back = std::min(1.0, dt / p.tracking);
    for (int i = 0; i < vector::RowsAtCompileTime; ++i)
      integral[i] += p.integral[i] > 0 ? dt * p.integral[i] * e[i] + back * (command[i] - wanted[i])
                                       : -back * integral[i];
    return {command, status_of(inputs.get())};
  }

  void on_start() {
    begun = false;
    integral.setZero();
  }

private:
  vector limited(const vector& wanted) const {
    const vector within = sample<Command>(wanted).clamped().vector();
    return within.cwiseMin(p.largest).cwiseMax(-p.largest);
  }

  vector integral = vector::Zero(), filtered = vector::Zero();
  vector proportional = vector::Zero(), derivative = vector::Zero();  // gains in the last firing
  bool begun = false;
};

}  // namespace cca
