// How the links of a robot differ from their description: a factor of the mass and of the length of each.
//
//   cca::sim::robot_world_settings s;
//   s.body.mass_of(-1) = 1.1;      // the base is 10 % heavier
//   s.body.length_of(2) = 0.98;    // link 2 is 2 % shorter
//
// A mass keeps its centre, and its inertia grows with it. A length scales all places on the link: the next
// joints, ends, shapes, springs' ends, sensors, its centre of mass; the shapes keep their sizes. A plain
// value; links beyond `most` are as described. A base that is held has no mass.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include <cca/sim/robot/model/robot_model.hpp>

namespace cca::sim {

struct body_factors {
  static constexpr std::size_t most = 64;  // links

  std::array<double, most + 1> mass, length;  // of the base, of each link

  constexpr body_factors() { mass.fill(1), length.fill(1); }

  // -1: the base. Throws std::out_of_range.
  constexpr double& mass_of(int link) { return mass.at(place(link)); }
  constexpr double& length_of(int link) { return length.at(place(link)); }

  constexpr double mass_factor(int link) const { return factor(mass, link); }
  constexpr double length_factor(int link) const { return factor(length, link); }
  constexpr bool has_lengths() const {
    for (const double f : length)
      if (f != 1) return true;
    return false;
  }

private:
  static constexpr std::size_t place(int link) { return static_cast<std::size_t>(link) + 1; }  // -1: 0
  static constexpr double factor(const std::array<double, most + 1>& of, int link) {
    const std::size_t i = place(link);
    return i < of.size() ? of[i] : 1;
  }
};

// A model with these factors.
inline robot_model varied(robot_model m, const body_factors& by) {
  const auto vary = [&by](link_inertia& of, int link) {
    const double mass = by.mass_factor(link), length = by.length_factor(link);
    of.mass *= mass;
    for (double& x : of.centre) x *= length;
    for (double& x : of.about_centre) x *= mass * length * length;
  };
  const auto lengthen = [&by](std::array<double, 3>& at, int link) {
    for (double& x : at) x *= by.length_factor(link);
  };
  const auto place = [&lengthen](place_on_link& p) { lengthen(p.where.translation, p.link); };
  if (m.floats) vary(m.base, -1);
  for (std::size_t i = 0; i < m.links.size(); ++i) {
    vary(m.links[i].inertia, static_cast<int>(i));
    lengthen(m.links[i].at, m.links[i].parent);
  }
  for (placed_shape& s : m.shapes) lengthen(s.where.translation, s.link);
  for (placed_spring& s : m.line_springs) place(s.from), place(s.to);
  for (auto* places : {&m.sensors, &m.inertial_units, &m.ends})
    for (place_on_link& p : *places) place(p);
  return m;
}

}  // namespace cca::sim
