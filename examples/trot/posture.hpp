#pragma once
// Holds the heading, leans into a slope, and rights the trunk when it rolls.
//
//   in  "orientation"   trunk_orientation
//   out "turn"          turning, -most to most
//   out "lean"          leaning
//
// It turns against the trunk's yaw, and against the integral of the yaw, which is about how far the robot has
// walked aside.
//
// On a slope the trunk pitches with the ground and the weight moves to the lower feet. So the hips follow the
// mean pitch: uphill (nose up, negative) the feet move back, under the weight. After a push from the side the
// trunk rolls to and fro; without damping that grows, most of all downhill. So the knees of the side that
// goes down extend, and those of the other side flex. Neither leans farther than `most_lean`.
//
// While the orientation is not finite, both outputs stay as they are.
#include <algorithm>
#include <cmath>
#include <tuple>

#include <cca/cca.hpp>

#include "spaces.hpp"

namespace trot {

struct posture {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0, 10>, heading),  // turn per rad of yaw
                             (cca::bounded<double, 0, 10>, drift),    // turn per rad s of yaw
                             (cca::bounded<double, 0, 1>, most),      // turn
                             (cca::bounded<double, 0, 1>, upright),   // of the hips, rad per rad of pitch
                             (cca::quantity<cca::duration, 0.01, 60>, average),  // of the pitch, s
                             (cca::bounded<double, 0, 3>, level),   // of the knees, rad per rad of roll
                             (cca::bounded<double, 0, 0.2>, damp),  // of the knees, rad per rad/s of roll
                             (cca::quantity<cca::angle, 0, 1>, most_lean));  // of hips and of knees
  };
  parameters p{1.29, 0.5, 0.5, 0.78, 1.0, 0.79, 0.017, 0.5};

  auto process(cca::in<"orientation", oncilla::trunk_orientation> trunk, cca::beat now)
      -> std::tuple<cca::out<"turn", turning>, cca::out<"lean", leaning>> {
    const double yaw = trunk.yaw(), pitch = trunk.pitch(), roll = trunk.roll();
    if (std::isfinite(yaw + pitch + roll)) {
      const double largest = p.drift > 0 ? p.most / p.drift : 0.0;  // more has no effect
      aside = std::clamp(aside + now.dt() * yaw, -largest, largest);
      turn = std::clamp(-p.heading * yaw - p.drift * aside, -p.most, +p.most);
      slope += std::min(1.0, now.dt() / p.average) * (pitch - slope);
      const double rolling = (roll - last_roll) / now.dt();
      last_roll = roll;
      hips = std::clamp(p.upright * slope, -p.most_lean, +p.most_lean);
      knees = std::clamp(p.level * roll + p.damp * rolling, -p.most_lean, +p.most_lean);
    }
    return {turn, leaning::vector_type(hips, knees)};
  }

  void on_start() { aside = slope = last_roll = turn = hips = knees = 0; }

private:
  double aside = 0;            // rad s
  double slope = 0;            // rad, the mean pitch
  double last_roll = 0;        // rad
  double turn = 0;             // the outputs
  double hips = 0, knees = 0;  // rad
};

}  // namespace trot
