#pragma once
// What an arm is told in the tests of rollouts: a wave, as wide as the run says.
#include <cmath>
#include <cstddef>

#include <cca/cca.hpp>
#include <cca/robots/arm/description.hpp>

namespace rollouts_test {

using namespace cca;
namespace arm = robots::arm;

struct waving {
  double wide = 0.1;  // rad
  auto process(beat now) -> out<"angles", arm::angles> {
    const double way = wide * (1 - std::cos(6e-9 * static_cast<double>(now.time())));
    arm::angles::vector_type q;
    for (Eigen::Index i = 0; i < 7; ++i) q[i] = arm::description::start[static_cast<std::size_t>(i)] + way;
    return q;
  }
};

}  // namespace rollouts_test
