// The components of the synthetic graphs, on samples of two axes: as small as possible, so that the cost of
// the library shows.
#pragma once

#include <cca/component/beat.hpp>
#include <cca/component/port.hpp>
#include <cca/space/domain.hpp>

namespace bench {

struct plane : cca::space<cca::number, cca::axes<cca::x, cca::y>> {};

// A ramp.
struct source {
  Eigen::Vector2d value{0, 1};
  auto process(cca::beat now) -> cca::out<"y", plane> {
    value[0] += now.dt();
    value[1] -= now.dt();
    return value;
  }
};

// A first-order low-pass.
struct filter {
  double gain = 0.25;
  Eigen::Vector2d state{0, 0};
  auto process(cca::in<"x", plane> x) -> cca::out<"y", plane> {
    state += gain * (x.vector() - state);
    return state;
  }
};

}  // namespace bench
