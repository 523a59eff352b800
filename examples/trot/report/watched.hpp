#pragma once
// An architecture of an Oncilla as its programs run it: recorded, traced, and with the robot's pose for the
// page. With the options --record and --replay, where recordings are there.
#include <cca/cca.hpp>
#include <cca/graph/items/shows.hpp>
#include <cca/main.hpp>
#include <cca/robots/oncilla/legged_body.hpp>

#if __has_include(<cca/record.hpp>)
#include <cca/record.hpp>                // offers --record
#include <cca/record/replay_option.hpp>  // offers --replay
#endif
#if __has_include(<cca/door.hpp>)
#include <cca/door.hpp>  // offers --door
#endif

namespace trot {

template <class Architecture>
struct watched
    : Architecture,
      cca::recordable,
      cca::traceable,
      cca::shows<cca::robots::oncilla::legged_body, "robot.angles", "robot.simulator.orientation"> {};

}  // namespace trot
