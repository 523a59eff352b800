// <link> elements: mass, inertia and the shapes that touch. What is only drawn (<visual>) is not read.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "elements.hpp"
#include "model.hpp"

namespace cca_urdf {

// Right angles are often written with few digits, as 1.5708. The rotations of exact ones consist of 0 and 1,
// which vanish when the compiler works out the dynamics; those of the others do not.
inline double right_angle(double angle) {
  constexpr double quarter_turn = std::numbers::pi / 2;
  const double right = std::round(angle / quarter_turn) * quarter_turn;
  return std::abs(angle - right) <= 1e-5 ? right : angle;
}

inline origin read_origin(const element& e, const reader& from) {
  const element* at = child_of(e, "origin", from.said());
  if (!at) return {};
  const std::array<double, 3> zero{};
  origin o{from.list<3>(*at, "xyz", zero), from.list<3>(*at, "rpy", zero)};
  for (double& angle : o.rpy) {
    const double right = right_angle(angle);
    if (std::abs(right - angle) > 1e-9)  // else it was meant, with ten digits
      from.note(*at, "the angle " + text_of(angle) + " of an <origin> becomes " + text_of(right) +
                         ": it is within 1e-5 of a multiple of a right angle");
    angle = right;
  }
  return o;
}

inline std::optional<inertial> read_inertial(const element& e, const reader& from, const std::string& owner) {
  const element* mass = from.needed_child(e, "mass");
  const element* inertia = from.needed_child(e, "inertia");
  if (!mass || !inertia) return {};
  const long before = from.said().errors();
  inertial of{e.GetLineNum(), read_origin(e, from), {}};
  of.own.mass = from.number(*mass, "value");
  const double xx = from.number(*inertia, "ixx"), yy = from.number(*inertia, "iyy"),
               zz = from.number(*inertia, "izz"), xy = from.number(*inertia, "ixy"),
               xz = from.number(*inertia, "ixz"), yz = from.number(*inertia, "iyz");
  of.own.about_centre << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  if (of.own.mass < 0)
    from.error(*mass, "a mass of " + text_of(of.own.mass) + " kg; it must not be negative");
  if (from.said().errors() > before) return {};
  if (of.own.mass == 0) {  // a frame without a body, as some programs write it
    if (!of.own.about_centre.isZero(0))
      from.said().note(inertia->GetLineNum(), owner + ": an inertia without a mass is left out");
    return {};
  }
  return of;
}

inline void read_collision(const element& e, const reader& from, const std::string& owner, link& into) {
  const element* geometry = from.needed_child(e, "geometry");
  const element* form = geometry ? geometry->FirstChildElement() : nullptr;
  if (!geometry) return;
  if (!form || form->NextSiblingElement()) return from.error(*geometry, "<geometry> needs one shape");
  const long before = from.said().errors();
  collision c{form->GetLineNum(), form_kind::sphere, {}, read_origin(e, from)};
  const std::string kind = form->Name();
  const auto left_out = [&](const std::string& why) { from.said().note(c.line, owner + ": " + why); };
  if (kind == "mesh") {
    const char* file = form->Attribute("filename");
    return left_out("the mesh '" + std::string(file ? file : "") +
                    "' is left out: shapes are boxes, spheres and capsules, so nothing touches it");
  }
  if (kind == "box") {
    c.kind = form_kind::box;
    c.size = from.list<3>(*form, "size", {});
  } else if (kind == "sphere") {
    c.size[0] = from.number(*form, "radius");
  } else if (kind == "cylinder" || kind == "capsule") {
    c.kind = kind == "capsule" ? form_kind::capsule : form_kind::cylinder;
    c.size = {from.number(*form, "radius"), from.number(*form, "length"), 0};
  } else {
    return left_out("the shape " + tag(*form) + " is left out: shapes are boxes, spheres and capsules");
  }
  if (from.said().errors() > before) return;
  const std::size_t sizes = c.kind == form_kind::box ? 3 : c.kind == form_kind::sphere ? 1 : 2;
  const double least = *std::min_element(c.size.begin(), c.size.begin() + static_cast<std::ptrdiff_t>(sizes));
  if (least < 0) return from.error(*form, "each size of " + tag(*form) + " must be above 0");
  if (least == 0) return left_out("the " + kind + " is left out: one of its sizes is 0");
  into.collisions.push_back(c);
}

inline link read_link(const element& e, remarks& said) {
  link l{reader("a link", said).text(e, "name"), e.GetLineNum(), {}, {}};
  const reader from(named(l), said);
  if (const element* i = child_of(e, "inertial", said)) l.inertia = read_inertial(*i, from, named(l));
  for (const element* c = e.FirstChildElement("collision"); c; c = c->NextSiblingElement("collision"))
    read_collision(*c, from, named(l), l);
  return l;
}

}  // namespace cca_urdf
