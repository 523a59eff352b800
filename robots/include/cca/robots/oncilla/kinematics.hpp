// The legs of an Oncilla as kinematic chains, with the lengths of body.hpp.
//
//   struct left_front : cca::pantograph_leg<trunk_frame, foot, cca::axes<abduction, hip, knee>,
//                                           cca::robots::oncilla::leg_geometry(0)> {};
//
// The base is the trunk's frame, the tip is the centre of the foot's sphere with the toe straight.
#pragma once

#include <cstddef>

#include <cca/mapping/pantograph.hpp>
#include <cca/robots/oncilla/body.hpp>

namespace cca::robots::oncilla {

constexpr cca::pantograph leg_geometry(std::size_t leg) {
  const double side = side_of(leg);
  return {.upper = body.upper_length,
          .middle = body.middle_length,
          .lower = body.foot_lever(),
          .side = side,
          .hip = cca::at((is_front(leg) ? body.hip_x : -body.hip_x) - body.trunk_forward_of_hips,
                         side * body.hip_y, -body.trunk_above_hips)};
}

}  // namespace cca::robots::oncilla
