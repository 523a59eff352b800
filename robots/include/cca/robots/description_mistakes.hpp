// What can be wrong in the description of a robot, and the sentences that name it. description.hpp looks for
// it, in the order that matters. Cost: constants; the sentences are compiled only where one is broken.
// Errors: robot.description.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/messages/tell_names.hpp>
#include <cca/robot/body_tree.hpp>
#include <cca/robots/crossing.hpp>
#include <cca/robots/groups.hpp>
#include <cca/robots/line_spring.hpp>
#include <cca/robots/sensors.hpp>
#include <cca/robots/shape.hpp>
#include <cca/space/messages/space_in_words.hpp>

namespace cca::robots::detail {

using cca::detail::axes_in_words;
using cca::detail::axis_in_words;
using cca::detail::type_name;

// `Has...`: what it states.
template <class R, bool HasBody, bool HasRate, bool HasCommands, bool HasDrives>
struct members_missing {
  static constexpr void tell(auto& m) {
    const char* between = " lacks `";
    const auto lacks = [&](bool has, std::string_view member) {
      if (has) return;
      m << between << member << "`";
      between = ", `";
    };
    m << "robot.description: " << type_name<R>();
    lacks(HasBody, "body"), lacks(HasRate, "rate"), lacks(HasCommands, "commands"),
        lacks(HasDrives, "drives");
    m << ": the description of a robot states `body`, which is a cca::body, `rate`, `commands` and `drives`, "
         "as in cca/robots/description.hpp";
  }
};

template <class R>
struct wrong_drive_count {
  static constexpr void tell(auto& m) {
    using axes = axes_of<typename R::body>;
    m << "robot.description: `drives` of " << type_name<R>() << " has "
      << static_cast<std::int64_t>(R::drives.size()) << (R::drives.size() == 1 ? " entry" : " entries")
      << ", and its body has " << axes::count << (axes::count == 1 ? " axis (" : " axes (")
      << axes_in_words<axes>()
      << "): give one for each axis, in the order of cca::axes_of<body>, also for a passive joint";
  }
};

// The first joint with a motor that is not measured; -1: there is none.
template <class R>
constexpr int unmeasured_motor = [] {
  for (std::size_t i = 0; i < R::drives.size(); ++i)
    if (!R::drives[i].measured && R::drives[i].motor.torque != 0) return static_cast<int>(i);
  return -1;
}();
template <class R>
struct motor_not_measured {
  static constexpr void tell(auto& m) {
    m << "robot.description: the joint `" << axis_in_words(axes_of<typename R::body>(), unmeasured_motor<R>)
      << "` of " << type_name<R>()
      << " has a motor and is not measured, so nobody could command it; leave out `measured = false`, or the "
         "motor";
  }
};

// `Measured`: the axes that ports may have.
template <class R, class Measured>
struct port_over_other_axis {
  static constexpr void tell(auto& m) {
    if (look(m, typename R::commands())) return;
    if constexpr (requires { typename R::readings; }) look(m, typename R::readings());
  }

private:
  template <template <class...> class List, class... Ports>
  static constexpr bool look(auto& m, List<Ports...>) {
    const auto one = [&]<class Port>(std::type_identity<Port>) {
      if constexpr (requires { typename Port::space; }) return each<Port>(m, typename Port::space::axes());
      else return false;
    };
    return (one(std::type_identity<Ports>()) || ...);
  }
  template <class Port, class... Axes>
  static constexpr bool each(auto& m, axes<Axes...>) {
    return (one<Port, Axes>(m) || ...);
  }
  template <class Port, class Axis>
  static constexpr bool one(auto& m) {
    if (Measured::template contains<Axis>) return false;
    m << "robot.description: the port `" << Port::name.view() << "` of " << type_name<R>()
      << " is over the axis " << type_name<Axis>()
      << (axes_of<typename R::body>::template contains<Axis> ? ", which is not measured"
                                                             : ", which its body lacks")
      << "; take it out of the space of that group, in `commands` or `readings`";
    return true;
  }
};

template <class R, class Commands = typename R::commands>
struct commanded_twice;
template <class R, class... Commands>
struct commanded_twice<R, commands<Commands...>> {
  static constexpr void tell(auto& m) { (void)(of<Commands>(m) || ...); }

private:
  template <class A>
  static constexpr bool of(auto& m) {
    return (both<A, Commands>(m) || ...);
  }
  template <class A, class B>
  static constexpr bool both(auto& m) {
    if constexpr (Grouped<A> && Grouped<B> && !std::is_same_v<A, B>) {
      if constexpr (A::kind == B::kind) return share<A, B>(m, typename A::space::axes());
    }
    return false;
  }
  template <class A, class B, class... Axes>
  static constexpr bool share(auto& m, axes<Axes...>) {
    return (shared<A, B, Axes>(m) || ...);
  }
  template <class A, class B, class Axis>
  static constexpr bool shared(auto& m) {
    if (!B::space::axes::template contains<Axis>) return false;
    m << "robot.description: the joint `" << type_name<Axis>() << "` of " << type_name<R>()
      << " is in the groups `" << A::name.view() << "` and `" << B::name.view()
      << "`, which have the same kind of command; take it out of the space of one of them, in `commands`";
    return true;
  }
};

// The first link that no torque could move; -1: there is none.
template <class Body>
constexpr int massless_link = [] {
  const auto& links = cca::detail::body_tree_of<Body>.links;
  for (std::size_t i = 0; i < links.size(); ++i)
    if (!(links[i].inertia.mass > 0) && crossing_after(links, i) < 0) return static_cast<int>(i);
  return -1;
}();
template <class R>
struct link_without_mass {
  static constexpr void tell(auto& m) {
    using body = typename R::body;
    const auto& link = cca::detail::body_tree_of<body>.links[static_cast<std::size_t>(massless_link<body>)];
    m << "robot.description: the link that the joint `" << axis_in_words(axes_of<body>(), link.coordinate)
      << "` of " << type_name<R>()
      << " moves has no mass, so no torque could move it; give each link an inertia, in `links` of its "
         "chain; only a link between two hinges that cross at right angles needs none";
  }
};
template <class R>
struct base_without_mass {
  static constexpr void tell(auto& m) {
    m << "robot.description: " << type_name<R>()
      << " floats, but the base of its body has no mass; add `static constexpr cca::link_inertia base{...};` "
         "to the body";
  }
};

template <class Body, class Parts>
struct joints_by_part;
template <class Body, class... Parts>
struct joints_by_part<Body, std::tuple<Parts...>> {
  static constexpr std::array<int, sizeof...(Parts)> count{static_cast<int>(Parts::chain::joints.size())...};
};
template <class Body>
constexpr int links_of_part(int part) {
  return joints_by_part<Body, typename Body::parts>::count[static_cast<std::size_t>(part)];
}

template <class Body>
constexpr bool place_exists(std::string_view part_name, int link) {
  if (link == shape_on::base) return true;
  const int part = part_index<Body>(part_name);
  return part >= 0 && link >= shape_on::tip && link < links_of_part<Body>(part);
}
// Of a place that does not exist.
template <class Body>
constexpr void tell_place(auto& m, std::string_view part_name, int link) {
  if (const int part = part_index<Body>(part_name); part >= 0) {
    m << "link " << link << " of the part `" << part_name << "`, which has " << links_of_part<Body>(part)
      << ", counted from 0: correct the number";
  } else {
    m << "the part `" << part_name << "`, which its body lacks";
    cca::detail::tell_names(m, part_name, Body::attached::names);
  }
}

// The first shape on no place of the body; -1: there is none.
template <class R>
constexpr int lost_shape = [] {
  if constexpr (requires { R::shapes.size(); })
    for (std::size_t i = 0; i < R::shapes.size(); ++i)
      if (!place_exists<typename R::body>(R::shapes[i].part, R::shapes[i].link)) return static_cast<int>(i);
  return -1;
}();
template <class R>
struct shape_on_nothing {
  static constexpr void tell(auto& m) {
    const shape_on& lost = R::shapes[static_cast<std::size_t>(lost_shape<R>)];
    m << "robot.description: `shapes[" << lost_shape<R> << "]` of " << type_name<R>() << " is on ";
    tell_place<typename R::body>(m, lost.part, lost.link);
  }
};

template <class R>
constexpr int lost_spring = [] {
  if constexpr (requires { R::line_springs.size(); })
    for (std::size_t i = 0; i < R::line_springs.size(); ++i)
      for (const point_of_robot& p : {R::line_springs[i].from, R::line_springs[i].to})
        if (!place_exists<typename R::body>(p.part, p.link)) return static_cast<int>(i);
  return -1;
}();
template <class R>
struct spring_on_nothing {
  static constexpr void tell(auto& m) {
    const line_spring& lost = R::line_springs[static_cast<std::size_t>(lost_spring<R>)];
    const bool begins = place_exists<typename R::body>(lost.from.part, lost.from.link);
    const point_of_robot& end = begins ? lost.to : lost.from;
    m << "robot.description: the " << (lost.only_pulls ? "cable" : "spring") << " `line_springs["
      << lost_spring<R> << "]` of " << type_name<R>() << " ends on ";
    tell_place<typename R::body>(m, end.part, end.link);
  }
};

// The part of a sensor that the body lacks; "": there is none.
template <class Body, class Sensor>
constexpr std::string_view lost_part() {
  for (const std::string_view part : Sensor::parts)
    if (part_index<Body>(part) < 0 && !(is_inertial<Sensor> && part.empty()))
      return part.empty() ? std::string_view("(none)") : part;
  return {};
}
template <class Body, class... Sensors>
constexpr bool all_parts_exist(sensors<Sensors...>) {
  return (lost_part<Body, Sensors>().empty() && ...);
}
template <class R, class Sensors>
struct sensor_on_nothing;
template <class R, class... Sensors>
struct sensor_on_nothing<R, sensors<Sensors...>> {
  static constexpr void tell(auto& m) { (void)(one<Sensors>(m) || ...); }

private:
  template <class Sensor>
  static constexpr bool one(auto& m) {
    using body = typename R::body;
    constexpr auto part = lost_part<body, Sensor>();
    if (part.empty()) return false;
    m << "robot.description: the sensor `" << Sensor::name.view() << "` of " << type_name<R>()
      << " is at the end of the part `" << part << "`, which its body lacks";
    cca::detail::tell_names(m, part, body::attached::names);
    return true;
  }
};

}  // namespace cca::robots::detail
