// Checks the numbers of a scene and of the engine when a world is made. It refuses what the engine can't
// take, or would take for another number, and names it:
//
//   "cca::sim: the size of box 2 of the scene along y is nan m: it must be above 0"
//
// Errors: std::invalid_argument. A terrain is judged where it is made (terrain.hpp).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <cca/mapping/placement.hpp>
#include <cca/sim/engine/engine_settings.hpp>
#include <cca/sim/engine/refused_number.hpp>
#include <cca/sim/engine/scene.hpp>

namespace cca::sim {

namespace detail {

inline constexpr std::array directions{" along x", " along y", " along z"};

inline void need_above_0(double value, const std::string& what, std::string_view unit) {
  need(std::isfinite(value) && value > 0, what, value, unit, "above 0");
}
inline void need_at_least_0(double value, const std::string& what, std::string_view unit) {
  need(std::isfinite(value) && value >= 0, what, value, unit, "a number of at least 0");
}
inline void need_finite(double value, const std::string& what, std::string_view unit) {
  need(std::isfinite(value), what, value, unit, "a finite number");
}
inline void need_finite(const std::array<double, 3>& values, const std::string& what, std::string_view unit) {
  for (std::size_t k = 0; k < 3; ++k) need_finite(values[k], what + directions[k], unit);
}

}  // namespace detail

// A place in the world: finite, and its rotation is one. The engine makes a unit quaternion of it.
inline bool is_place(const placement& where) {
  double sum = 0, square = 0;
  for (const double x : where.translation) sum += std::abs(x);
  for (const double q : where.rotation) square += q * q;
  return std::isfinite(sum) && std::isfinite(square) && square > 0;
}
inline void need_place(const placement& where, const std::string& of) {
  if (is_place(where)) return;
  detail::need_finite(where.translation, "the place of " + of, "m");
  double square = 0;
  for (const double q : where.rotation) square += q * q;
  need(false, "the square of the quaternion of " + of, square, "",
       "1: a rotation is a unit quaternion x, y, z, w");
}

inline scene checked(scene s) {
  if (s.floor) detail::need_finite(*s.floor, "the height of the floor", "m");
  for (std::size_t i = 0; i < s.boxes.size(); ++i) {
    const std::string box = "box " + std::to_string(i) + " of the scene";
    for (std::size_t k = 0; k < 3; ++k)
      detail::need_above_0(s.boxes[i].size[k], "the size of " + box + detail::directions[k], "m");
    need_place(s.boxes[i].where, box);
  }
  for (std::size_t i = 0; i < s.balls.size(); ++i) {
    const std::string ball = "ball " + std::to_string(i) + " of the scene";
    detail::need_above_0(s.balls[i].radius, "the radius of " + ball, "m");
    detail::need_above_0(s.balls[i].mass, "the mass of " + ball, "kg");
    detail::need_finite(s.balls[i].position, "the place of " + ball, "m");
    detail::need_finite(s.balls[i].velocity, "the velocity of " + ball, "m/s");
  }
  detail::need_at_least_0(s.contact.stiffness, "the stiffness of contacts", "N/m");
  detail::need_at_least_0(s.contact.damping, "the damping of contacts", "N s/m");
  detail::need_above_0(s.contact.stiffness + s.contact.damping, "the stiffness plus damping of contacts", "");
  detail::need_at_least_0(s.contact.friction, "the friction of contacts", "");
  return s;
}

inline void check(const engine_settings& s) {
  detail::need_finite(s.gravity, "gravity", "m/s^2");
  need(s.erp >= 0 && s.erp <= 1, "`erp`", s.erp, "", "from 0 to 1");
  detail::need_at_least_0(s.cfm, "`cfm`", "");
  need(s.correcting_speed >= 0, "the correcting speed of contacts", s.correcting_speed, "m/s", "at least 0");
  detail::need_at_least_0(s.surface_layer, "the surface layer of contacts", "m");
}

}  // namespace cca::sim
