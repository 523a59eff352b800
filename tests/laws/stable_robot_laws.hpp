// The laws of a simulated robot that nothing pushes: for 10 s it is finite and within its stops, and then it
// is at rest, whatever its masses, dampings, springs, servos and rate.
//
//   comes_to_rest(model)     the worst of what it did; its `trouble` names what a world found itself
//   comes_to_rest_in(world)  the same of a world of either engine
//   random_stiff_robot(random, hz)   light and heavy links, dampings and stiffnesses over many decades
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <cca/sim/robot/world/robot_world.hpp>

#include "space_laws.hpp"

namespace laws {

struct rest {
  std::string trouble;
  double beyond_stop = 0;    // rad or m, at most
  double speed = 0;          // rad/s or m/s, at the end, at most
  double chatter = 0;        // how much a speed changes in the last 20 beats, at most
  std::vector<double> pose;  // of the coordinates, at the end
};

template <class World>  // a robot_world or a compiled_world
rest comes_to_rest_in(World w, const std::vector<cca::sim::joint_law>& drives = {}, double seconds = 10) {
  rest seen;
  const cca::sim::robot_model& model = w.model();
  const std::size_t count = w.joints().size();
  std::vector<double> least(count, 1e300), most(count, -1e300);
  const auto beats = static_cast<int>(seconds / model.beat);
  for (int k = 0; k < beats && !w.trouble(); ++k) {
    w.advance(drives);
    for (std::size_t c = 0; c < count; ++c) {
      const auto& [angle, velocity, torque] = w.joints()[c];
      if (!std::isfinite(angle + velocity + torque)) seen.trouble = "a reading is not finite";
      const cca::sim::joint_stops& s = model.stops[c];
      seen.beyond_stop = std::max({seen.beyond_stop, angle - s.high, s.low - angle});
      if (k + 20 < beats) continue;
      least[c] = std::min(least[c], velocity), most[c] = std::max(most[c], velocity);
    }
  }
  for (std::size_t c = 0; c < count; ++c) {
    seen.speed = std::max(seen.speed, std::abs(w.joints()[c].velocity));
    seen.chatter = std::max(seen.chatter, most[c] - least[c]);
    seen.pose.push_back(w.joints()[c].angle);
  }
  if (w.trouble()) seen.trouble = w.trouble_text();
  return seen;
}
inline rest comes_to_rest(const cca::sim::robot_model& model,
                          const std::vector<cca::sim::joint_law>& drives = {},
                          double seconds = 10,
                          const cca::sim::robot_world_settings& settings = {}) {
  return comes_to_rest_in(cca::sim::robot_world(model, {}, settings), drives, seconds);
}

// Uniform over the decades.
inline double decades(source& random, double low, double high) {
  return low * std::pow(high / low, random(0, 1));
}

// Four point masses within `size` of a centre.
inline cca::link_inertia random_body(source& random, double mass, double size) {
  cca::link_inertia of{mass, {}, {}};
  std::array<Eigen::Vector3d, 4> points;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (auto& p : points) p = random.vector(size), centre += p / 4;
  of.centre = {centre[0], centre[1], centre[2]};
  for (const auto& p : points) {
    const Eigen::Vector3d d = p - centre;
    const Eigen::Matrix3d m = mass / 4 * (d.dot(d) * Eigen::Matrix3d::Identity() - d * d.transpose());
    const std::array<double, 6> add{m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)};
    for (std::size_t k = 0; k < 6; ++k) of.about_centre[k] += add[k];
  }
  return of;
}

struct stiff_robot {
  cca::sim::robot_model model;
  std::vector<cca::sim::joint_law> drives;
};

// Nothing, a servo, or a constant torque, by a motor of any strength.
inline void joint_law_of(source& random,
                         cca::robots::joint_drive& d,
                         cca::sim::joint_law& law,
                         double weight) {
  const double kind = random(0, 1);
  if (kind < 0.4) return;
  d.motor = {weight * decades(random, 0.01, 100), decades(random, 0.3, 30)};
  if (kind < 0.5) {
    law.torque = random(-1, 1) * d.motor.torque;
    return;
  }
  law = {.position = random(-0.4, 0.4), .stiffness = weight * decades(random, 0.1, 1e4)};
  law.damping = law.stiffness * decades(random, 0.001, 1);
}

// A chain or tree on a fixed base. Each joint has enough friction that it must come to rest in 10 s, and much
// more in most; some have springs, servos, weak motors, strings to the base and followers.
inline stiff_robot random_stiff_robot(source& random, double hz) {
  stiff_robot r;
  cca::sim::robot_model& m = r.model;
  m.beat = 1 / hz;
  const auto count = static_cast<std::size_t>(random(1, 6.999));
  double mass = 0, reach = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const int last = static_cast<int>(i) - 1;
    const int parent = random(0, 1) < 0.7 ? last : static_cast<int>(random(0, last + 1.999)) - 1;
    const double size = decades(random, 0.02, 0.4);
    cca::joint j;
    j.kind = random(0, 1) < 0.8 ? cca::joint_kind::revolute : cca::joint_kind::prismatic;
    const Eigen::Vector3d axis = random.vector(1).normalized(), at = random.vector(size);
    j.axis = {axis[0], axis[1], axis[2]};
    j.where = cca::at(at[0], at[1], at[2]);
    auto& link =
        m.links.emplace_back(cca::detail::body_link_of(j, static_cast<int>(m.drives.size()), parent));
    if (i > 0 && random(0, 1) < 0.15) {  // follows the joint before it
      link.coordinate = m.links[i - 1].coordinate;
      link.ratio = random(0.3, 2) * (random(0, 1) < 0.5 ? -1 : 1);
    } else {
      m.drives.emplace_back();
    }
    link.inertia = random_body(random, decades(random, 0.005, 30), size);
    mass += link.inertia.mass, reach += 2 * size + 0.5;
  }
  // The slowest that can move it loses its motion within a second; the weakest servo can hold it.
  const double inertia = 4 * mass * reach * reach, weight = 9.81 * mass * reach;
  for (auto& d : m.drives) {
    d.friction = 2 * inertia * decades(random, 1, 1000);
    if (random(0, 1) < 0.4) d.friction = 2 * inertia;
    if (random(0, 1) < 0.3) d.spring = weight * decades(random, 0.1, 1000), d.spring_rest = random(-1, 1);
    joint_law_of(random, d, r.drives.emplace_back(), weight);
    m.stops.push_back({random(-2, -0.5), random(0.5, 2)});
    m.start.push_back(random(-0.5, 0.5));
  }
  for (int k = 0; k < 2 && random(0, 1) < 0.3; ++k) {
    const auto point = [&] {
      const Eigen::Vector3d p = random.vector(0.1);
      return cca::at(p[0], p[1], p[2]);
    };
    m.line_springs.push_back({{-1, cca::at(0, 0, 1)},
                              {static_cast<int>(random(0, static_cast<double>(count) - 0.001)), point()},
                              decades(random, 10, 1e6),
                              random(0.2, 1.5),
                              decades(random, 1, 1e4),
                              random(0, 1) < 0.5});
  }
  return r;
}

}  // namespace laws
