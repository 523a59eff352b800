// The sensors of a described robot (description.hpp), each one port under its name.
//
//   using sensors = cca::robots::sensors<
//       cca::robots::force_sensor<"flange_load", "arm">,            // wrench: N m, then N
//       cca::robots::orientation_sensor<"orientation", my_world>,   // unit quaternion, x y z w
//       cca::robots::gyroscope<"angular_velocity">,                 // rad/s
//       cca::robots::accelerometer<"acceleration", "head">,         // m/s^2; 9.81 upwards at rest
//       cca::robots::foot_loads<"loads", my_feet, "leg_1", "leg_2">,    // N, upwards: an axis for each part
//       cca::robots::foot_contacts<"contacts", my_feet, "leg_1", "leg_2">>;   // 1: it touches, 0: not
//
// A sensor sits where the part of its last argument ends, and reads along the axes of that frame. One of the
// inertial ones (the next three), without a part, sits in the origin of the base. `my_world` is the frame in
// which an orientation is given: that in which the robot is put down, z up. Errors: robot.description.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <cca/base/fixed_string.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/robot/body.hpp>
#include <cca/robots/inertial.hpp>
#include <cca/space/messages/space_in_words.hpp>
#include <cca/space/twist_wrench.hpp>

namespace cca::robots {

enum class sensor_kind { load, orientation, angular_velocity, specific_force, foot_load, foot_contact };

namespace detail {

// The frame in which a part ends; no part: the base.
template <class Body, fixed_string Part>
constexpr auto frame_of_sensor() {
  if constexpr (Part.view().empty()) {
    return std::type_identity<typename Body::base_frame>();
  } else {
    constexpr int index = part_index<Body>(Part.view());
    using part = std::tuple_element_t<static_cast<std::size_t>(index), typename Body::parts>;
    return std::type_identity<typename part::chain::tip_frame>();
  }
}
template <class Body, fixed_string Part>
using sensor_frame = typename decltype(frame_of_sensor<Body, Part>())::type;

template <fixed_string Name, fixed_string Part, sensor_kind Kind>
struct sensor {
  static constexpr auto name = Name;
  static constexpr auto part = Part;
  static constexpr sensor_kind kind = Kind;
  static constexpr std::array<std::string_view, 1> parts{Part.view()};
  using axes = cca::axes<x, y, z>;
};

template <fixed_string Name, class Feet, int Parts>
struct wrong_foot_count {
  static constexpr void tell(auto& m) {
    m << "robot.description: the sensor `" << Name.view() << "` has " << Feet::count << " axes ("
      << cca::detail::axes_in_words<Feet>() << ") and " << Parts << (Parts == 1 ? " part" : " parts")
      << "; name one part for each axis, in the same order";
  }
};

template <fixed_string Name, sensor_kind Kind, class Feet, fixed_string... Parts>
struct sensor_of_feet {
  static constexpr auto name = Name;
  static constexpr fixed_string part = "";
  static constexpr sensor_kind kind = Kind;
  static constexpr std::array<std::string_view, sizeof...(Parts)> parts{Parts.view()...};
  using axes = Feet;
  static_assert(cca::detail::holds_or_tells<(Feet::count == static_cast<int>(sizeof...(Parts))),
                                            wrong_foot_count<Name, Feet, sizeof...(Parts)>>::value);
};

}  // namespace detail

// The load of the world on all that is attached where a part ends, about the origin and along the axes of the
// part's tip frame. An ideal one: it reads contacts, not the weight of the tool.
template <fixed_string Name, fixed_string Part>
struct force_sensor : detail::sensor<Name, Part, sensor_kind::load> {
  template <class Body>
  using domain = wrench<detail::sensor_frame<Body, Part>, detail::sensor_frame<Body, Part>>;
};

template <fixed_string Name, class World, fixed_string Part = "">
struct orientation_sensor : detail::sensor<Name, Part, sensor_kind::orientation> {
  template <class Body>
  using domain = orientation<World>;
};

template <fixed_string Name, fixed_string Part = "">
struct gyroscope : detail::sensor<Name, Part, sensor_kind::angular_velocity> {
  template <class Body>
  using domain = angular_velocity<detail::sensor_frame<Body, Part>>;
};

template <fixed_string Name, fixed_string Part = "">
struct accelerometer : detail::sensor<Name, Part, sensor_kind::specific_force> {
  template <class Body>
  using domain = specific_force<detail::sensor_frame<Body, Part>>;
};

// Of all that is attached where the parts end: the vertical part of the world's force, and whether there is
// one. They read contacts, as force sensors do.
template <fixed_string Name, class Feet, fixed_string... Parts>
struct foot_loads : detail::sensor_of_feet<Name, sensor_kind::foot_load, Feet, Parts...> {
  template <class>
  using domain = foot_load;
};
template <fixed_string Name, class Feet, fixed_string... Parts>
struct foot_contacts : detail::sensor_of_feet<Name, sensor_kind::foot_contact, Feet, Parts...> {
  template <class>
  using domain = status;
};

template <class... Sensors>
struct sensors {};

template <class Sensor>
inline constexpr bool is_load = Sensor::kind == sensor_kind::load;
template <class Sensor>
inline constexpr bool is_of_feet =
    Sensor::kind == sensor_kind::foot_load || Sensor::kind == sensor_kind::foot_contact;
template <class Sensor>
inline constexpr bool is_inertial = !is_load<Sensor> && !is_of_feet<Sensor>;

namespace detail {

template <class... All>
constexpr std::size_t load_count(sensors<All...>) {
  return (std::size_t{is_load<All>} + ... + 0);
}

template <class Sensor, class... All>
constexpr std::size_t place_among_loads(sensors<All...>) {
  std::size_t place = 0;
  bool found = false;
  ((found = found || std::is_same_v<All, Sensor>, place += !found && is_load<All> ? 1 : 0), ...);
  return place;
}

template <class... All>
constexpr std::size_t feet_count(sensors<All...>) {
  std::size_t most = 0;
  ((most = is_of_feet<All> && All::parts.size() > most ? All::parts.size() : most), ...);
  return most;
}

// The parts of a sensor, by number.
template <class Sensor, class Body>
inline constexpr auto parts_of_sensor = [] {
  std::array<std::size_t, Sensor::parts.size()> all{};
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = static_cast<std::size_t>(part_index<Body>(Sensor::parts[i]));
  return all;
}();

// Inertial sensors of one part are one unit. The part of each unit, in the order in which they first occur.
template <class... All>
struct inertial_units {
  std::array<std::string_view, sizeof...(All)> parts{};
  std::size_t count = 0;

  constexpr inertial_units() { (add(All::part.view(), is_inertial<All>), ...); }
  constexpr std::size_t place_of(std::string_view part) const {
    std::size_t i = 0;
    while (i < count && parts[i] != part) ++i;
    return i;
  }

private:
  constexpr void add(std::string_view part, bool inertial) {
    if (inertial && place_of(part) == count) parts[count++] = part;
  }
};

template <class... All>
constexpr std::size_t unit_count(sensors<All...>) {
  return inertial_units<All...>().count;
}
template <class Sensor, class... All>
constexpr std::size_t unit_of(sensors<All...>) {
  return inertial_units<All...>().place_of(Sensor::part.view());
}

// The part of a unit's reading that a sensor publishes.
template <class Sensor, class Reading>
const auto& share_of(const Reading& unit) {
  if constexpr (Sensor::kind == sensor_kind::orientation) return unit.orientation;
  else if constexpr (Sensor::kind == sensor_kind::angular_velocity) return unit.angular_velocity;
  else return unit.specific_force;
}

}  // namespace detail
}  // namespace cca::robots
