// The shapes with which a robot touches the world, each on a link or at the end of a part.
//
//   static constexpr std::array shapes{
//       cca::robots::on_link("arm", 3, cca::robots::capsule(0.06, 0.2), cca::at(0, 0, -0.1)),
//       cca::robots::at_tip("arm", cca::robots::sphere(0.03))};
//
// A shape on a link is placed in the frame of that link (0: the first one of the part), one at the tip in the
// frame in which the part ends, one on the base in the frame of the base. What touches a shape at the tip is
// felt by the force sensor of that part. A capsule lies along z, its centre in the origin. Units: m.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <cca/mapping/placement.hpp>

namespace cca::robots {

enum class shape_kind : std::uint8_t { box, sphere, capsule };

// size: a box's three edges; a sphere's radius; a capsule's radius and the length between its two centres.
struct shape {
  shape_kind kind = shape_kind::sphere;
  std::array<double, 3> size{};
};

constexpr shape box(double x, double y, double z) { return {shape_kind::box, {x, y, z}}; }
constexpr shape sphere(double radius) { return {shape_kind::sphere, {radius, 0, 0}}; }
constexpr shape capsule(double radius, double length) { return {shape_kind::capsule, {radius, length, 0}}; }

struct shape_on {
  static constexpr int tip = -1, base = -2;

  std::string_view part;
  int link = tip;
  shape form;
  placement where{};
};

constexpr shape_on on_link(std::string_view part, int link, shape form, placement where = {}) {
  return {part, link, form, where};
}
constexpr shape_on at_tip(std::string_view part, shape form, placement where = {}) {
  return {part, shape_on::tip, form, where};
}
constexpr shape_on on_base(shape form, placement where = {}) { return {{}, shape_on::base, form, where}; }

}  // namespace cca::robots
