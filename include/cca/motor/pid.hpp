// A PID controller, each axis by itself.
//
//   cca::node<"servo", cca::pid<leg_angles, leg_torques>, cca::timed<1>>
//
//   in  "reference"  Measured                      the wanted value
//   in  "measured"   Measured
//   in  "manual"     Command                       optional: the command while "automatic" is 0
//   in  "automatic"  over<status, automatic_axis>  optional: 0 means manual
//   out "command"    Command                       within the limits of its axes, and at most `largest`
//
//   v = kp (r - y) + I + D,  u = v cut to the limits
//   I' = ki (r - y) + (u - v) / tracking        back-calculation: no wind-up
//   D  = -kd y_f',  filter y_f' = y - y_f       a step of the reference makes no kick
//
// Measured and Command are spaces with one number per axis. Gains: unit of Command per unit of Measured (ki:
// and per s, kd: times s); `filter` and `tracking` in s. The integral uses forward differences, the
// derivative backward ones: every filter time is stable. Transfers are bumpless: on a change from manual to
// automatic or of a gain the command continues without a jump. The difference decays through the integral or,
// with ki = 0, within the tracking time.
//
// Errors: none. While an input is not finite, the last command is held. Cost: about 20 operations per axis.
// Source: Astrom and Murray, Feedback Systems, 2008, sections 10.4, 10.5; Astrom and Hagglund, PID
// Controllers, 1995, section 3.5. Example: tests/runtime/motor/pid.cpp.
#pragma once

#include <algorithm>
#include <string_view>

#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/motor/spaces.hpp>

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
    std::string_view check() const {
      if (proportional.minCoeff() < 0 || integral.minCoeff() < 0 || derivative.minCoeff() < 0)
        return "a gain is negative";
      return largest.minCoeff() < 0 ? "`largest` is negative" : "";
    }
  };
  parameters p{vector::Ones(), vector::Zero(), vector::Zero(), 0.01, 0.1, vector::Constant(1e30)};

  auto process(in<"reference", Measured> reference,
               in<"measured", Measured> measured,
               optional_in<"manual", Command> manual,
               optional_in<"automatic", over<cca::status, automatic_axis>> automatic,
               beat now) -> out<"command", Command> {
    const bool by_hand = manual && automatic && automatic[automatic_axis{}] == 0;
    const vector y = measured.vector(), e = reference.vector() - y;
    if (!e.allFinite() || (by_hand && !manual.vector().allFinite())) return command;
    if (!begun) {
      filtered = y;
      proportional = p.proportional, derivative = p.derivative;
      begun = true;
    }
    const double dt = now.dt();
    const vector slope = (y - filtered) / (p.filter + dt);
    filtered += dt * slope;
    integral +=
        (proportional - p.proportional).cwiseProduct(e) - (derivative - p.derivative).cwiseProduct(slope);
    proportional = p.proportional, derivative = p.derivative;

    const vector direct = proportional.cwiseProduct(e) - derivative.cwiseProduct(slope);
    if (by_hand) {
      command = limited(manual.vector());
      integral = command - direct;
      return command;
    }
    const vector wanted = direct + integral;
    command = limited(wanted);
    const double back = std::min(1.0, dt / p.tracking);
    for (int i = 0; i < vector::RowsAtCompileTime; ++i)
      integral[i] += p.integral[i] > 0 ? dt * p.integral[i] * e[i] + back * (command[i] - wanted[i])
                                       : -back * integral[i];
    return command;
  }

  void on_start() {
    begun = false;
    integral.setZero();
    command.setZero();
  }

private:
  vector limited(const vector& wanted) const {
    const vector within = sample<Command>(wanted).clamped().vector();
    return within.cwiseMin(p.largest).cwiseMax(-p.largest);
  }

  vector integral = vector::Zero(), filtered = vector::Zero(), command = vector::Zero();
  vector proportional = vector::Zero(), derivative = vector::Zero();  // gains in the last firing
  bool begun = false;
};

}  // namespace cca
