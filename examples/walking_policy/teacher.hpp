#pragma once
// The trot from which the policies have learned, and where their robot is put down. The weights in the
// repository belong to it. The trot of examples/trot has changed since: it has other parameters.
#include "../trot/gait.hpp"
#include "../trot/posture.hpp"
#include "../trot/throttle.hpp"

namespace walking {

struct teacher : trot::gait {
  teacher() {
    using trot::degrees;
    p = {{degrees(45.5), degrees(93.2), degrees(14.8), degrees(40.4)},
         {degrees(36.1), degrees(87.0), degrees(18.3), degrees(53.2)},
         0.587,
         0.695,
         degrees(-0.2),
         -0.05,
         {0.0, 0.5, 0.373, -0.127},
         0.8};
  }
};

struct teachers_posture : trot::posture {
  teachers_posture() { p = {1.0, 0.4, 0.5, 0.72, 1.0, 1.2, 0.02, 0.5}; }
};

struct teachers_throttle : trot::throttle {
  teachers_throttle() { p = {0.66, 0.2, 0.191, 1.076}; }
};

}  // namespace walking
