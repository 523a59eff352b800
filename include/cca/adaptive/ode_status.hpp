// ODE Status: `converged` if the rate of change is close to zero, else `transient`, with hysteresis (the
// source document, chapter 3). Two more states follow the policy of input_status.hpp:
//
//   clamped      an input or a parameter was beyond what the component can do at this rate, and was cut
//   unreadable   an input is NaN or infinite: the state stands still
//
//   (cca::ode_settling, settling)                           in the parameters of a component
//   status.update(solver.rate(u, p).norm(), p.settling)     in process; published as
//                                                           out<"status", ode_status_port>
//
// It looks only at the state of the ode: a limit cycle never converges, however regular. The norm of the rate
// mixes the units of the coordinates; so do the thresholds (per s). A rate of NaN is transient.
#pragma once

#include <cstdint>
#include <string_view>

#include <cca/component/input_status.hpp>
#include <cca/component/field_types.hpp>
#include <cca/base/reflect.hpp>
#include <cca/space/methods/scalar.hpp>
#include <cca/space/space.hpp>

namespace cca {

enum class ode_status : std::uint8_t { transient, converged, clamped, unreadable };

struct ode_axis : dimension<"ode"> {};
struct ode_status_port : space<status, axes<ode_axis>> {};

struct ode_settling {
  BOOST_HANA_DEFINE_STRUCT(ode_settling,
                           (bounded<double, 0, infinity>, below),   // converged at this rate or slower, per s
                           (bounded<double, 0, infinity>, above));  // transient again above this rate
  constexpr ode_settling(double slow = 1e-3, double fast = 2e-3) : below(slow), above(fast) {}
  std::string_view check() const { return below <= above ? "" : "`below` is larger than `above`"; }
};

class ode_monitor {
public:
  ode_status update(double rate, const ode_settling& settling) {
    now = rate <= (now == ode_status::converged ? settling.above : settling.below) ? ode_status::converged
                                                                                   : ode_status::transient;
    return now;
  }
  ode_status get() const { return now; }

private:
  ode_status now = ode_status::transient;
};

// The number to publish: what was wrong with the inputs, else the state of the ode.
constexpr double status_of(input_status inputs, ode_status now) {
  return status_of(inputs == input_status::unreadable ? ode_status::unreadable
                   : inputs == input_status::clamped  ? ode_status::clamped
                                                      : now);
}

}  // namespace cca
