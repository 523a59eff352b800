// Springs and cables between two points of a robot, in a straight line.
//
//   static constexpr std::array line_springs{
//       cca::robots::cable(cca::robots::point_on("leg", 0, {0.02, 0, 0}),
//                          cca::robots::point_at_tip("leg"), 4000, 0.11, 5)};
//
// A cable only pulls: it is slack where it is shorter than its rest length, and its damping never pushes.
// Points are in the frames of shapes (shape.hpp). Units: N/m, m, N s/m.
#pragma once

#include <array>
#include <string_view>

#include <cca/robots/shape.hpp>

namespace cca::robots {

struct point_of_robot {
  std::string_view part;
  int link = shape_on::tip;
  std::array<double, 3> at{};
};

constexpr point_of_robot point_on(std::string_view part, int link, const std::array<double, 3>& at) {
  return {part, link, at};
}
constexpr point_of_robot point_at_tip(std::string_view part, const std::array<double, 3>& at = {}) {
  return {part, shape_on::tip, at};
}
constexpr point_of_robot point_on_base(const std::array<double, 3>& at) { return {{}, shape_on::base, at}; }

struct line_spring {
  point_of_robot from, to;
  double stiffness = 0, rest = 0, damping = 0;
  bool only_pulls = false;
};

constexpr line_spring cable(
    const point_of_robot& from, const point_of_robot& to, double stiffness, double rest, double damping = 0) {
  return {from, to, stiffness, rest, damping, true};
}

}  // namespace cca::robots
