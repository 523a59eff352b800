// The ground of a compiled world as plain numbers, and where a sphere or a corner touches it.
//
// A terrain is a row of strips (cca/sim/engine/terrain.hpp). The nearest point of a strip decides: above a
// strip it is as deep as its centre is near, so a sphere rolls over the edge of a step; what is below the
// surface of a strip is pushed up through it. The strip in which it is deepest counts. Beside the strip, the
// wall of a step is touched: what has come into it goes back through it, if that way is shorter.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include <cca/base/math.hpp>
#include <cca/sim/compiled/scalar.hpp>
#include <cca/sim/compiled/tree_motion.hpp>
#include <cca/sim/engine/checked_scene.hpp>
#include <cca/sim/engine/scene.hpp>
#include <cca/sim/engine/terrain.hpp>

namespace cca::sim::detail {

// A height that no strip of a terrain rises above, near a place: what is higher touches nothing.
template <class Number>
struct ground_bound {
  Number start{0.0}, rises{0.0};  // m along x; the mean slope from there on
  Number step{0.0}, least{0.0};   // m: how far a step is above this line; the height of the last strip

  constexpr ground_bound() = default;
  explicit ground_bound(const ground_profile& p)
    requires std::is_same_v<Number, double>
  {
    if (p.is_level()) return;
    start = p.start, rises = p.rise == 0 ? math::tan(p.pitch) : p.rise / p.run;
    step = p.rise > 0 ? p.rise : 0;
    least = p.rise == 0 ? -std::numeric_limits<double>::infinity() : static_cast<double>(p.count) * p.rise;
  }
  void take_lane(int k, const ground_bound<double>& one) {
    start.set(k, one.start), rises.set(k, one.rises), step.set(k, one.step), least.set(k, one.least);
  }
  // m above the first strip, of all that is at most `reach` from x.
  template <class Real>
  Real top(const Real& x, double reach) const {
    const Real zero(0.0), along = x - Real(start), up(rises);
    const Real high = Real(step) + up * (along + Real(reach)), low = up * (along - Real(reach));
    return select(up < zero, larger(smaller(low, zero), Real(least)), larger(high, zero));
  }
};

struct ground {
  bool exists = false;
  double floor = 0;  // m, of the first strip
  ground_profile profile{};
  ground_bound<double> bound{};
  contact_numbers contact{};
  double surface_layer = 0, correcting_speed = 0;

  bool is_level() const { return profile.is_level(); }
  bool has_walls() const { return profile.rise != 0; }
  double friction() const { return contact.friction; }

  // Whether worlds on both can be lanes: only the ground's shape and its friction differ.
  bool goes_with(const ground& b) const {
    return exists == b.exists && contact.stiffness == b.contact.stiffness &&
           contact.damping == b.contact.damping && contact.pyramid == b.contact.pyramid &&
           surface_layer == b.surface_layer && correcting_speed == b.correcting_speed;
  }
};

// Of each lane its own.
template <class Real>
struct ground_in_lanes {
  bool exists = false;
  contact_numbers contact{};  // but the friction
  double surface_layer = 0, correcting_speed = 0;
  ground_bound<Real> bound{};

  constexpr ground_in_lanes() = default;
  ground_in_lanes(const ground& all) {
    for (int k = 0; k < Real::count; ++k) take_lane(k, all);
  }
  // `take_lane` of each lane, in their order; they go together.
  void take_lane(int k, const ground& one) {
    exists = one.exists, contact = one.contact;
    surface_layer = one.surface_layer, correcting_speed = one.correcting_speed;
    is_level_ = (k == 0 || is_level_) && one.is_level();
    has_walls_ = (k > 0 && has_walls_) || one.has_walls();
    lanes_[static_cast<std::size_t>(k)] = one;
    friction_.set(k, one.friction()), floor_.set(k, one.floor), bound.take_lane(k, one.bound);
  }

  bool is_level() const { return is_level_; }  // in all lanes
  bool has_walls() const { return has_walls_; }
  const Real& friction() const { return friction_; }
  const ground& lane(int k) const { return lanes_[static_cast<std::size_t>(k)]; }

  const Real& floor() const { return floor_; }

private:
  std::array<ground, static_cast<std::size_t>(Real::count)> lanes_{};
  Real friction_{}, floor_{};
  bool is_level_ = true, has_walls_ = false;
};

// Throws std::invalid_argument for what no world can have, and for what this one has not.
inline ground ground_of(const scene& around, const engine_settings& settings) {
  const scene s = checked(around);
  if (s.floor && s.ground)
    throw std::invalid_argument(
        "cca::sim::compiled_world: the scene has a floor and a terrain; give one of them, or "
        "use cca::sim::robot_world, which has both");
  ground g;
  g.exists = s.floor || s.ground;
  if (s.floor) g.floor = *s.floor;
  g.contact = s.contact;
  if (s.ground) g.profile = s.ground->profile(), g.contact.friction = s.ground->friction();
  g.bound = ground_bound<double>(g.profile);
  g.surface_layer = settings.surface_layer, g.correcting_speed = settings.correcting_speed;
  return g;
}

inline double height_of(const ground& g, double x) {
  return g.exists ? g.floor + g.profile.height(x) : -std::numeric_limits<double>::infinity();
}

// Of a place above the first strip, m.
template <class Real>
Real height_above(const ground& g, const triple<Real>& at) {
  return at[2] - Real(g.floor);
}
template <class Real>
Real height_above(const ground_in_lanes<Real>& g, const triple<Real>& at) {
  return at[2] - g.floor();
}

template <class Real>
struct ground_touch {
  Real depth{};  // m; below 0: it doesn't touch
  triple<Real> normal{Real(0.0), Real(0.0), Real(1.0)};
};

constexpr double plain(double x) { return x; }

// Of what is at this place how far the wall of a step at its height is, m: below 0 behind it.
template <class Real>
struct step_wall {
  bool exists = false;
  bool is_way_out = false;  // from behind it, shorter than up
  Real before{};
  triple<Real> normal{Real(1.0), Real(0.0), Real(0.0)};
};
// Steps rise or fall all along, so at one height all is free on one side of one wall.
template <class Real>
step_wall<Real> wall_at(const ground& g, const triple<Real>& at) {
  step_wall<Real> w;
  const ground_profile& p = g.profile;
  if (!g.has_walls()) return w;
  const double x = plain(at[0]), z = plain(at[2]) - g.floor, n = math::floor(z / p.rise);
  if (!(n >= 0 && n < static_cast<double>(p.count))) return w;
  const Real past = at[0] - Real(p.start + n * p.run);
  w.exists = true, w.before = p.rise > 0 ? Real(-1.0) * past : past;
  w.normal[0] = Real(p.rise > 0 ? -1.0 : 1.0);
  // What stands on a step within its edge is not behind the wall.
  if (const double behind = -plain(w.before); behind >= 0)
    w.is_way_out = behind + 2 * g.surface_layer < p.height(x) - z;
  return w;
}

// The wall of a step touches a sphere or a corner beside what touches it from below.
template <class Real>
ground_touch<Real> touch_of_wall(const ground& g, const triple<Real>& at, double radius) {
  ground_touch<Real> best;
  best.depth = Real(-1.0);
  const step_wall<Real> w = wall_at(g, at);
  if (w.exists && (plain(w.before) > 0 || w.is_way_out)) best = {Real(radius) - w.before, w.normal};
  return best;
}

// A sphere, or with radius 0 a corner, at this place in the world.
template <class Real>
ground_touch<Real> touch_of(const ground& g, const triple<Real>& at, double radius) {
  ground_touch<Real> best;
  best.depth = Real(-1.0);
  if (!g.exists) return best;
  const double x = plain(at[0]);
  g.profile.strips_between(x - radius, x + radius, [&](const ground_strip& s) {
    const bool is_level = s.pitch == 0;
    const double c = is_level ? 1 : math::cos(s.pitch), n = is_level ? 0 : math::sin(s.pitch);
    // In the plane of x and z, from the strip's edge: along it, and above it.
    const Real dx = at[0] - Real(s.edge_x), dz = at[2] - Real(g.floor + s.edge_z);
    const Real along = Real(c) * dx + Real(n) * dz, above = Real(c) * dz - Real(n) * dx;
    const double begin = (s.begin - s.edge_x) / c, end = (s.end - s.edge_x) / c;
    const Real beyond = larger(along - Real(end), Real(0.0)) + smaller(along - Real(begin), Real(0.0));
    ground_touch<Real> t;
    if (plain(beyond) == 0 || !(plain(above) > 0)) {
      t = {Real(radius) - above, {Real(-n), Real(0.0), Real(c)}};
      if (plain(beyond) != 0) return;  // below, and beside
      if (g.has_walls() && wall_at(g, at).is_way_out) return;
    } else {
      const Real far = root(beyond * beyond + above * above), u = beyond / far, v = above / far;
      t = {Real(radius) - far, {Real(c) * u - Real(n) * v, Real(0.0), Real(n) * u + Real(c) * v}};
    }
    if (best.depth < t.depth) best = t;
  });
  return best;
}

// Whether what is at most `reach` from this place is above all ground; in lanes, in each.
template <class Ground, class Real>
auto is_surely_above(const Ground& g, const triple<Real>& at, double reach) {
  return height_above(g, at) > g.bound.top(at[0], reach) + Real(reach + 1e-9);
}

// Of each lane on its own ground.
template <class Real, class Touch>
ground_touch<Real> touch_in_lanes(const ground_in_lanes<Real>& g,
                                  const triple<Real>& at,
                                  double radius,
                                  Touch touch) {
  ground_touch<Real> all;
  const Real above = select(is_surely_above(g, at, radius), Real(1.0), Real(0.0));
  for (int k = 0; k < Real::count; ++k) {
    if (above[k] > 0) {
      all.depth.set(k, -1);
      continue;
    }
    const ground_touch<double> one = touch(g.lane(k), lane_of(at, k));
    all.depth.set(k, one.depth), set_lane(all.normal, k, one.normal);
  }
  return all;
}
template <class Real>
ground_touch<Real> touch_of_wall(const ground_in_lanes<Real>& g, const triple<Real>& at, double radius) {
  return touch_in_lanes(g, at, radius, [&](const ground& own, const triple<double>& a) {
    return touch_of_wall(own, a, radius);
  });
}
template <class Real>
ground_touch<Real> touch_of(const ground_in_lanes<Real>& g, const triple<Real>& at, double radius) {
  if (!g.is_level())
    return touch_in_lanes(
        g, at, radius, [&](const ground& own, const triple<double>& a) { return touch_of(own, a, radius); });
  ground_touch<Real> on;
  on.depth = Real(radius) - height_above(g, at);
  return on;
}

}  // namespace cca::sim::detail
