// Two hinges whose axes cross at right angles, with a link without mass between them: a hip, a universal
// joint.
//
// Such a link needs no mass, because nothing moves it alone. It may carry nothing: no shape, no spring, no
// other link. The simulator makes one joint of the two (cca/sim/robot/tree/tree_in_engine.hpp).
#pragma once

#include <cstddef>

#include <cca/mapping/serial_chain.hpp>

namespace cca::robots::detail {

// The link after a link without mass, if the two form such a joint; else -1. `links`: those of a body.
template <class Links>
constexpr int crossing_after(const Links& links, std::size_t link) {
  using cca::detail::body_link;
  const body_link& first = links[link];
  if (first.inertia.mass != 0 || first.kind != joint_kind::revolute) return -1;
  int next = -1;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links[i].parent != static_cast<int>(link)) continue;
    if (next >= 0) return -1;
    next = static_cast<int>(i);
  }
  if (next < 0) return -1;
  const body_link& second = links[static_cast<std::size_t>(next)];
  if (second.kind != joint_kind::revolute || !(second.inertia.mass > 0)) return -1;
  double along = 0, apart = 0;
  for (std::size_t row = 0; row < 3; ++row) {
    double axis = 0;  // of the second, in the frame of the first; `turn` has columns
    for (std::size_t column = 0; column < 3; ++column)
      axis += second.turn[3 * column + row] * second.axis[column];
    along += axis * first.axis[row];
    apart += second.at[row] * second.at[row];
  }
  constexpr double nearly = 1e-12;
  return along < nearly && along > -nearly && apart < nearly * nearly ? next : -1;
}

}  // namespace cca::robots::detail
