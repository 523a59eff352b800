// A described robot (cca/robots/description.hpp) as numbers, for the engine.
//
//   const cca::sim::robot_model m = cca::sim::model_of<cca::robots::arm::description>();
//
// A value: a changed copy of it is another robot. It is made outside of the loop; it allocates.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <cca/robots/description.hpp>
#include <cca/sim/robot/model/own_pairs.hpp>
#include <cca/space/limits.hpp>

namespace cca::sim {

// A shape in the frame of a link (-1: the base), the force sensor that feels it (-1: none), and the part at
// whose end it is (-1: none).
struct placed_shape {
  int link = -1;
  robots::shape form{};
  placement where{};
  int sensor = -1, end = -1;
};

// A place on a link.
struct place_on_link {
  int link = -1;
  placement where{};
};

// A spring or a cable between two points.
struct placed_spring {
  place_on_link from, to;
  double stiffness = 0, rest = 0, damping = 0;
  bool only_pulls = false;
};

// The stops of a joint; infinite: none. A range with one end has no stops, nor has a drive that says so.
struct joint_stops {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();

  double middle() const { return std::isfinite(high - low) ? (low + high) / 2 : 0; }
};

// What a robot's description calls them, in order; a model made by hand may leave them out.
struct robot_names {
  std::vector<std::string> joints, ends, sensors, inertial;  // coordinates, parts, sensors of each kind
};

// How far the stops of a joint are from their middle, of its own angle; 0: it has none. The engine's stops
// are for hinges of less than a turn.
inline double stop_reach(const cca::detail::body_link& l, const joint_stops& s) {
  const double reach = std::abs(l.ratio) * (s.high - s.low) / 2;
  const bool has = std::isfinite(reach) && (l.kind == joint_kind::prismatic || reach < std::numbers::pi);
  return has ? reach : 0;
}

struct robot_model {
  std::vector<cca::detail::body_link> links;  // each after the one to which it is attached
  link_inertia base{};
  bool floats = false;
  std::vector<robots::joint_drive> drives;  // over the coordinates
  std::vector<joint_stops> stops;           // over the coordinates
  std::vector<double> start;                // over the coordinates, rad
  std::vector<placed_shape> shapes;
  std::vector<std::array<std::size_t, 2>> own_pairs;  // of shapes that may touch each other
  std::vector<placed_spring> line_springs;
  std::vector<place_on_link> sensors;         // of forces
  std::vector<place_on_link> inertial_units;  // one for each place with inertial sensors
  std::vector<place_on_link> ends;            // of the parts, in order of declaration
  std::vector<int> unit_of;                   // of each inertial sensor, among the inertial units
  robot_names names{};
  double beat = 0.001;  // s

  std::string joint_name(std::size_t c) const {
    return c < names.joints.size() ? names.joints[c] : "coordinate " + std::to_string(c);
  }
};

// Throws std::out_of_range with all names that there are.
inline std::size_t index_of(const std::vector<std::string>& names,
                            std::string_view name,
                            std::string_view of) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return i;
  std::string text =
      "cca::sim: this robot has no " + std::string(of) + " `" + std::string(name) + "`; it has";
  for (const std::string& each : names) text += (&each == &names[0] ? " `" : ", `") + each + "`";
  throw std::out_of_range(names.empty() ? text + " none with a name" : text);
}

// Throws std::invalid_argument for numbers that no joint, spring or shape can have.
inline robot_model checked(robot_model m) {
  const auto need = [](double value, bool good, const std::string& what, const char* number) {
    if (!good || !std::isfinite(value))
      throw std::invalid_argument("cca::sim::robot: " + std::string(number) + " of " + what + " is " +
                                  std::to_string(value) + ", but must be a number of at least 0");
  };
  for (std::size_t c = 0; c < m.drives.size(); ++c) {
    const robots::joint_drive& d = m.drives[c];
    const std::string of = "joint `" + m.joint_name(c) + "`";
    need(d.friction, d.friction >= 0, of, "the friction");
    need(d.dry_friction, d.dry_friction >= 0, of, "the dry friction");
    need(d.spring, d.spring >= 0, of, "the spring");
    need(d.spring_rest, true, of, "the rest of the spring");
    need(d.stiffness, d.stiffness >= 0, of, "the stiffness of the servo");
    need(d.damping, d.damping >= 0, of, "the damping of the servo");
    need(d.cable.stiffness, d.cable.stiffness >= 0, of, "the stiffness of the cable");
    need(d.cable.damping, d.cable.damping >= 0, of, "the damping of the cable");
    need(d.motor.torque, d.motor.torque >= 0, of, "the torque of the motor");
    need(d.motor.no_load_speed, d.motor.torque == 0 || d.motor.no_load_speed > 0, of,
         "the no-load speed of the motor");
  }
  for (std::size_t i = 0; i < m.line_springs.size(); ++i) {
    const placed_spring& s = m.line_springs[i];
    const std::string of = "spring " + std::to_string(i);
    need(s.stiffness, s.stiffness >= 0, of, "the stiffness");
    need(s.damping, s.damping >= 0, of, "the damping");
    need(s.rest, s.rest >= 0, of, "the rest length");
  }
  for (std::size_t i = 0; i < m.shapes.size(); ++i) {
    for (const double size : m.shapes[i].form.size)
      need(size, size >= 0, "shape " + std::to_string(i), "a size");
  }
  return m;
}

namespace detail {

template <class... Axes>
std::vector<joint_stops> stops_of(axes<Axes...>) {
  return {joint_stops{cca::detail::lower_limit_of<Axes, angle>, cca::detail::upper_limit_of<Axes, angle>}...};
}

template <class... Axes>
std::vector<std::string> names_of(axes<Axes...>) {
  return {std::string(Axes::label.view())...};
}

// Returns the parts of the force sensors.
template <class Body, class... Sensors>
std::vector<int> place_sensors(robot_model& m, robots::sensors<Sensors...>) {
  const auto end_of = [&m](int part) {
    return part < 0 ? place_on_link{} : m.ends[static_cast<std::size_t>(part)];
  };
  std::vector<int> sensed_parts;
  [[maybe_unused]] const auto keep = [&](bool load, std::string_view part) {
    if (load) sensed_parts.push_back(part_index<Body>(part));
  };
  (keep(robots::is_load<Sensors>, Sensors::part.view()), ...);
  for (const int part : sensed_parts) m.sensors.push_back(end_of(part));
  const robots::detail::inertial_units<Sensors...> units;
  [[maybe_unused]] const auto name = [&]<class Sensor>(std::type_identity<Sensor>) {
    const std::string label(Sensor::name.view());
    if constexpr (robots::is_inertial<Sensor>) {
      m.names.inertial.push_back(label);
      m.unit_of.push_back(static_cast<int>(robots::detail::unit_of<Sensor>(robots::sensors<Sensors...>())));
    } else if constexpr (robots::is_load<Sensor>) {
      m.names.sensors.push_back(label);
    }
  };
  (name(std::type_identity<Sensors>()), ...);
  for (std::size_t i = 0; i < units.count; ++i)
    m.inertial_units.push_back(end_of(part_index<Body>(units.parts[i])));
  return sensed_parts;
}

// `ends`, `sensed_parts`: places and numbers of parts. `links`: those of each part (links_by_part).
template <class Links, class Ends, class Parts>
constexpr placed_shape placed(
    const robots::shape_on& s, int part, const Links& links, const Ends& ends, const Parts& sensed_parts) {
  if (s.link == robots::shape_on::base) return {-1, s.form, s.where, -1};
  const auto p = static_cast<std::size_t>(part);
  if (s.link >= 0) return {links[p].at(static_cast<std::size_t>(s.link)), s.form, s.where, -1};
  int sensor = -1;
  for (std::size_t i = 0; i < sensed_parts.size(); ++i)
    if (sensed_parts[i] == part) sensor = static_cast<int>(i);
  const place_on_link& end = ends[p];
  return {end.link, s.form, end.where * s.where, sensor, part};
}

template <class Body, class Links, class Ends>
constexpr place_on_link placed(const robots::point_of_robot& p, const Links& links, const Ends& ends) {
  const placement there = at(p.at[0], p.at[1], p.at[2]);
  if (p.link == robots::shape_on::base) return {-1, there};
  const auto part = static_cast<std::size_t>(part_index<Body>(p.part));
  if (p.link >= 0) return {links[part].at(static_cast<std::size_t>(p.link)), there};
  return {ends[part].link, ends[part].where * there};
}

// The links of a part, in the order of its joints.
template <std::size_t Most>
struct links_of_part {
  std::array<int, Most> link{};
  std::size_t count = 0;

  constexpr int at(std::size_t i) const { return link.at(i); }
};
template <class Body>
constexpr auto links_by_part() {
  constexpr const auto& tree = cca::detail::body_tree_of<Body>;
  std::array<links_of_part<tree.links.size() + 1>, tree.ends.size()> all{};
  for (std::size_t part = 0; part < all.size(); ++part) {
    const int parent = Body::attached::parent[part];
    const int before = parent < 0 ? -1 : tree.ends[static_cast<std::size_t>(parent)].link;
    auto& links = all[part];
    for (int at = tree.ends[part].link; at != before; at = tree.links[static_cast<std::size_t>(at)].parent)
      links.link[links.count++] = at;
    std::reverse(links.link.begin(), links.link.begin() + static_cast<std::ptrdiff_t>(links.count));
  }
  return all;
}
template <class Body>
constexpr auto ends_of() {
  std::array<place_on_link, cca::detail::body_tree_of<Body>.ends.size()> all{};
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = {cca::detail::body_tree_of<Body>.ends[i].link, cca::detail::body_tree_of<Body>.ends[i].where};
  return all;
}

}  // namespace detail

template <class R>
robot_model model_of() {
  static_assert(robots::check_description<R>());
  using body = typename R::body;
  constexpr const auto& tree = cca::detail::body_tree_of<body>;
  robot_model m;
  m.links.assign(tree.links.begin(), tree.links.end());
  m.base = cca::detail::base_inertia_of<body>();
  m.floats = robots::floats<R>;
  m.drives.assign(R::drives.begin(), R::drives.end());
  m.stops = detail::stops_of(axes_of<body>());
  for (std::size_t c = 0; c < m.drives.size(); ++c)
    if (!m.drives[c].stops) m.stops[c] = {};
  m.start.assign(m.drives.size(), 0);
  if constexpr (requires { R::start.size(); }) m.start.assign(R::start.begin(), R::start.end());
  for (const auto& end : tree.ends) m.ends.push_back({end.link, end.where});
  m.names.joints = detail::names_of(axes_of<body>());
  m.names.ends.assign(body::attached::names.begin(), body::attached::names.end());
  const std::vector<int> sensed = detail::place_sensors<body>(m, robots::sensors_of<R>());
  if constexpr (requires { R::shapes.size(); }) {
    const auto links = detail::links_by_part<body>();
    for (const robots::shape_on& s : R::shapes) {
      const int part = part_index<body>(s.part);
      m.shapes.push_back(detail::placed(s, part, links, m.ends, sensed));
    }
  }
  if constexpr (robots::touches_itself<R>)
    detail::each_own_pair(
        m.shapes, [&](int link) { return m.links[static_cast<std::size_t>(link)].parent; },
        [&](std::size_t i, std::size_t j) { m.own_pairs.push_back({i, j}); });
  if constexpr (requires { R::line_springs.size(); }) {
    const auto links = detail::links_by_part<body>();
    for (const robots::line_spring& s : R::line_springs)
      m.line_springs.push_back({detail::placed<body>(s.from, links, m.ends),
                                detail::placed<body>(s.to, links, m.ends), s.stiffness, s.rest, s.damping,
                                s.only_pulls});
  }
  m.beat = 1 / cca::detail::hz_of<typename R::rate>;
  return m;
}

}  // namespace cca::sim
