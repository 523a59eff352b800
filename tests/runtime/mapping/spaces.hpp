// Frames, spaces and placements for the tests of this folder.
#pragma once

#include <cca/mapping/mapping.hpp>
#include <cca/mapping/mapping_chain.hpp>
#include <cca/mapping/rigid_motion.hpp>

#include "../../laws/mapping_laws.hpp"

namespace mapping_test {

struct world : cca::frame<"world"> {};
struct trunk : cca::frame<"trunk"> {};
struct hip : cca::frame<"hip"> {};
using xyz = cca::axes<cca::x, cca::y, cca::z>;

struct foot_in_hip : cca::space<cca::cartesian_position<hip>, xyz> {};
struct foot_in_trunk : cca::space<cca::cartesian_position<trunk>, xyz> {};
struct foot_in_world : cca::space<cca::cartesian_position<world>, xyz> {};
struct foot_in_plane : cca::space<cca::cartesian_position<hip>, cca::axes<cca::x, cca::z>> {};
struct turn_in_hip : cca::space<cca::orientation<hip>, xyz> {};
struct turn_in_trunk : cca::space<cca::orientation<trunk>, xyz> {};
struct pose_in_hip : cca::space<cca::pose<hip>, xyz> {};
struct pose_in_trunk : cca::space<cca::pose<trunk>, xyz> {};
struct twist_at_hip : cca::space<cca::twist<hip, hip>, xyz> {};
struct twist_at_trunk : cca::space<cca::twist<trunk, trunk>, xyz> {};
struct twist_at_hip_in_trunk : cca::space<cca::twist<hip, trunk>, xyz> {};
struct wrench_at_hip : cca::space<cca::wrench<hip, hip>, xyz> {};
struct wrench_at_trunk : cca::space<cca::wrench<trunk, trunk>, xyz> {};
struct wrench_at_hip_in_trunk : cca::space<cca::wrench<hip, trunk>, xyz> {};

struct hip_in_trunk : cca::placed<hip, trunk> {
  static constexpr auto where = cca::at(0.12, 0.07, -0.02) * cca::turned_about({1, 2, -1}, 0.7);
};
struct trunk_in_world : cca::placed<trunk, world> {
  static constexpr auto where = cca::at(3, 0, 0.2) * cca::turned_about(cca::along_z, 1.5);
};

}  // namespace mapping_test
