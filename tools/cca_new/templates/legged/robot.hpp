// The robot: the quadruped Oncilla, 5 kg, with three commanded joints a leg. For a robot of your own, write a
// description like <cca/robots/oncilla/description.hpp>.
//
// Its legs are left front, right front, left hind, right hind; each has abduction, hip and knee, in this
// order.
#pragma once

#include <cca/cca.hpp>
#include <cca/robots/oncilla/description.hpp>
#include <cca/robots/oncilla/spaces.hpp>
#include <cca/robots/ports.hpp>

namespace my_robot {

using cca::robots::oncilla::description;
using body = description::body;
using angles = cca::robots::angles<description>;              // rad, of the twelve joints
using orientation = cca::robots::oncilla::trunk_orientation;  // of the trunk, in the world

}  // namespace my_robot
