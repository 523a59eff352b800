#pragma once
// Who pushes the arm: external torques that the force sensor at the flange does not explain.
//
//   in  "external"  arm::torques   of the momentum observer
//   in  "angles"    arm::angles
//   in  "load"      load           on the flange
//   out "status"    contact_port   enum cca::contact: none, reacting
//
// The load passes a filter as slow as the observer's. The status changes when some torque has been above
// `threshold` for `confirm`, and back when all have been below half of it for `release`.
#include <numbers>

#include <cca/component/parameters.hpp>
#include <cca/robot/compliance/contact_reaction.hpp>
#include <cca/robot/derived_of_body.hpp>

#include "spaces.hpp"

namespace touch {

struct watch {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0, 1000>, threshold),
                             (cca::quantity<cca::duration, 0, 10>, confirm),
                             (cca::quantity<cca::duration, 0, 10>, release),
                             (cca::quantity<cca::frequency, 0.1, 1000>, bandwidth));
    parameters() : threshold(3), confirm(0.03), release(0.2), bandwidth(20) {}
  };
  parameters p{};

  auto process(cca::in<"external", arm::torques> external,
               cca::in<"angles", arm::angles> angles,
               cca::in<"load", load> sensed,
               cca::beat now,
               cca::derived<cca::jacobian_of<arm::body, "arm">, "angles"> jacobian)
      -> cca::out<"status", cca::contact_port> {
    const double w = 2 * std::numbers::pi * p.bandwidth * now.dt();
    const vector due = jacobian.of(angles).transpose() * sensed.vector();
    if (due.allFinite()) felt += w / (1 + w) * (due - felt);
    const vector left = (external.vector() - felt).cwiseAbs();
    const bool pushes = left.maxCoeff() > p.threshold, rests = left.maxCoeff() < 0.5 * p.threshold;
    const bool reacts = state == cca::contact::reacting;
    lasts = (reacts ? rests : pushes) ? lasts + now.dt() : 0;
    if (lasts > (reacts ? p.release : p.confirm)) {
      state = reacts ? cca::contact::none : cca::contact::reacting;
      lasts = 0;
    }
    return cca::status_of(state);
  }

  void on_start() { felt.setZero(), lasts = 0, state = cca::contact::none; }

private:
  using vector = arm::torques::vector_type;
  vector felt = vector::Zero();
  double lasts = 0;
  cca::contact state = cca::contact::none;
};

}  // namespace touch
