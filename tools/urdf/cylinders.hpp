// Shapes are boxes, spheres and capsules. A cylinder that is longer than wide becomes a capsule; a flat one
// that turns about its own axis, a wheel, a sphere, which rolls as well; any other flat one a box, which
// stands as well.
#pragma once

#include <cmath>
#include <string>

#include "bodies.hpp"

namespace cca_urdf {

namespace detail {

// Whether its body turns about its axis.
inline bool is_wheel(const collision& c, const place_in_body& at, const bodies& all) {
  const joint* by = all.all()[static_cast<std::size_t>(at.body)].moved_by;
  if (!by || by->type == joint_type::prismatic) return false;
  const Eigen::Vector3d own = (at.placed * c.where.placed()).linear().col(2);
  return std::abs(own.dot(Eigen::Vector3d(by->axis[0], by->axis[1], by->axis[2]).normalized())) > 0.99;
}

inline std::string replace_cylinder(collision& c, bool rolls) {
  const double radius = c.size[0], length = c.size[1];
  if (length > 2 * radius) {
    c.kind = form_kind::capsule, c.size = {radius, length - 2 * radius, 0};
    return "the cylinder becomes a capsule of the same length and radius: its edges are round";
  }
  if (rolls) {
    c.kind = form_kind::sphere, c.size = {radius, 0, 0};
    return "the cylinder, a wheel, becomes a sphere of the same radius: it is wider";
  }
  c.kind = form_kind::box, c.size = {2 * radius, 2 * radius, length};
  return "the flat cylinder becomes a box of the same height and width: it has corners";
}

}  // namespace detail

inline void replace_cylinders(robot& r, const bodies& all, remarks& said) {
  for (std::size_t i = 0; i < r.links.size(); ++i)
    for (collision& c : r.links[i].collisions)
      if (const auto& at = all.place(static_cast<int>(i)); c.kind == form_kind::cylinder && at.body >= 0)
        said.note(c.line,
                  named(r.links[i]) + ": " + detail::replace_cylinder(c, detail::is_wheel(c, at, all)));
}

}  // namespace cca_urdf
