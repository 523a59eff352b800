#pragma once
// Holds the heading: turns against the trunk's yaw, and against the integral of the yaw, which is about how
// far the robot has walked aside.
//
//   in  "orientation"   trunk_orientation
//   out "turn"          turning, -most to most
#include <algorithm>

#include <cca/cca.hpp>

#include "spaces.hpp"

namespace trot {

struct posture {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0, 10>, heading),  // turn per rad of yaw
                             (cca::bounded<double, 0, 10>, drift),    // turn per rad s of yaw
                             (cca::bounded<double, 0, 1>, most));     // turn
  };
  parameters p{1.2, 0.4, 0.5};

  auto process(cca::in<"orientation", oncilla::trunk_orientation> trunk, cca::beat now)
      -> cca::out<"turn", turning> {
    const double yaw = trunk.yaw();
    const double largest = p.drift > 0 ? p.most / p.drift : 0.0;  // more has no effect
    aside = std::clamp(aside + now.dt() * yaw, -largest, largest);
    return std::clamp(-p.heading * yaw - p.drift * aside, -p.most, +p.most);
  }

private:
  double aside = 0;  // rad s
};

}  // namespace trot
