// The Tracking Criterion: does the robot follow the command of the module? (the source document, section 6.3)
//
//   cca::tracking<leg_angles>
//
//   in  "target"     S                the command of the module
//   in  "feedback"   S                the measured value
//   out "error"      criterion_error  unit of S: the largest error of an axis; of positions the distance
//   out "state"      criterion_port
//
// Parameters `limits`: within, until, lost (unit of S), hold (s). The delay of a good servo is an error too:
// choose `within` large enough. Before both inputs have a sample it is open, with error zero.
//
// While an input is NaN or infinite: error 1e12, state `lost`; afterwards `open`, and `hold` restarts.
//
// Errors: none. Cost: negligible. Example: tests/runtime/adaptive/tracker.cpp; docs/adaptive.md.
#pragma once

#include <tuple>

#include <cca/adaptive/criterion.hpp>

namespace cca {
namespace detail {

template <class S>
using limits_of_error = error_limits<typename distance_quantity<typename S::domain>::type>;

template <class S>
struct comparing {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (limits_of_error<S>, limits));
  };
  parameters p{};

  auto process(in<"target", S> target, in<"feedback", S> feedback, beat now)
      -> std::tuple<out<"error", criterion_error>, out<"state", criterion_port>> {
    if (target.origin() == never || feedback.origin() == never) return {0.0, status_of(monitor.get())};
    const double error = apart<S>(target, feedback);
    return {error_to_publish(error), status_of(monitor.update(error, p.limits, now.dt()))};
  }

  void on_start() { monitor = {}; }

private:
  error_monitor monitor;
};

}  // namespace detail

template <Space S>
struct tracking : detail::comparing<S> {
  static constexpr criterion_target compares = criterion_target::command;
  static constexpr bool at_rest = false;
};

}  // namespace cca
