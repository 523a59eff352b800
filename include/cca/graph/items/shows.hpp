// cca::shows: a base of a recordable graph, by which a recording shows its robot in viewers.
//
//   struct trot : cca::graph<...>, cca::recordable,
//                 cca::shows<body, "robot.angles", "robot.orientation"> {};
//
//   Body          a cca::body
//   Angles        the output that has the angle of each of its axes, and may have more
//   Orientation   the output with the orientation of its base in the world; without it the base is the world
//
// Both are paths from the outermost graph; each may name what an inner graph exposes, as the end of a wire
// does. Errors: recording.unknown_port, recording.wrong_port, from a recorder and from cca::check.
// docs/recordings.md.
#pragma once

#include <concepts>
#include <string_view>

#include <cca/base/fixed_string.hpp>

namespace cca {

template <class Body, fixed_string Angles, fixed_string Orientation = "">
struct shows {
  using cca_shown_body = Body;
  static constexpr std::string_view cca_shown_angles = Angles.view();
  static constexpr std::string_view cca_shown_orientation = Orientation.view();
};

namespace detail {

template <class Graph> concept ShowsBody = requires { typename Graph::cca_shown_body; };

}  // namespace detail
}  // namespace cca
