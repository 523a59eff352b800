// Serial chains: joints in a row from one frame to another, as constants of a named struct.
//
//   struct arm : cca::serial_chain<trunk, hand, cca::axes<shoulder, elbow>> {
//     static constexpr std::array joints{cca::revolute(cca::along_z, cca::at(0, 0.1, 0)),
//                                        cca::revolute(cca::along_y, cca::at(0.3, 0, 0))};
//     static constexpr cca::placement tip = cca::at(0.25, 0, 0);
//     static constexpr std::array<cca::link_inertia, 2> links{...};   // optional: inertia of each link
//   };
//
// A joint is placed in the frame of the link before it (the first one in the base of the chain) with its
// angle at 0, and moves what follows about or along its axis. The tip is placed in the last link. Each joint
// has a coordinate, by default that of its own index. A coupled joint names the coordinate of another joint
// and a ratio: a pantograph is two joints of one coordinate with ratios 1 and -1. Instead it can name the
// axis, `.driven_by("elbow", -1)`; in a body (robot/body.hpp) also one of another part. Units: m, rad
// (coordinate of a prismatic joint: m), kg, kg m^2. An axis has a length other than 0; it is normalised.
// Errors: mapping.bad_chain.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/mapping/placement.hpp>
#include <cca/space/messages/space_in_words.hpp>
#include <cca/space/space.hpp>

namespace cca {

enum class joint_kind : std::uint8_t { revolute, prismatic };

struct joint {
  joint_kind kind = joint_kind::revolute;
  std::array<double, 3> axis = along_z;
  placement where{};
  int coordinate = -1;  // -1: the index of the joint
  double ratio = 1;     // angle of the joint = ratio * coordinate + rest
  double rest = 0;
  std::string_view follows{};  // the name of an axis, instead of its coordinate

  // The same joint, moved by another coordinate, or by an axis.
  constexpr joint driven_by(int other, double by = 1, double at_zero = 0) const {
    return {kind, axis, where, other, by, at_zero};
  }
  constexpr joint driven_by(std::string_view name, double by = 1, double at_zero = 0) const {
    return {kind, axis, where, -1, by, at_zero, name};
  }
};

constexpr joint revolute(const std::array<double, 3>& axis, const placement& where = {}) {
  return {joint_kind::revolute, axis, where};
}
constexpr joint prismatic(const std::array<double, 3>& axis, const placement& where = {}) {
  return {joint_kind::prismatic, axis, where};
}

// Mass in kg, its centre in the frame of the link in m, the inertia about that centre along the axes of the
// link in kg m^2: xx, yy, zz, xy, xz, yz (the products with the signs of the matrix).
struct link_inertia {
  double mass = 0;
  std::array<double, 3> centre{};
  std::array<double, 6> about_centre{};
};

template <class Base, class Tip, class Axes>
struct serial_chain {
  using base = Base;
  using tip_frame = Tip;
  using axes = Axes;
};

template <class Type> concept SerialChain = requires {
  typename Type::base;
  typename Type::tip_frame;
  typename Type::axes;
  { Type::tip } -> std::convertible_to<placement>;
  Type::joints.size();
};

namespace detail {

template <class Type>
inline constexpr bool has_ends = requires {
  typename Type::base;
  typename Type::tip_frame;
  typename Type::axes;
};
template <class Type>
inline constexpr bool has_joints = requires { Type::joints.size(); };
template <class Type>
inline constexpr bool has_tip = requires {
  { Type::tip } -> std::convertible_to<placement>;
};

template <class Type>
struct no_chain {
  static constexpr void tell(text& m) {
    m << "mapping.bad_chain: ";
    if (!has_ends<Type>) {
      m << "a chain is wanted, and `" << type_name<Type>();
      if constexpr (requires { typename Type::parts; })
        m << "` is a body: name the chain of one of its parts, or use what takes the whole body, as "
             "cca::body_pose";
      else if constexpr (requires { typename Type::body; })
        m << "` is the description of a robot: name the chain of a part of `" << type_name<Type>()
          << "::body`, or use what takes the whole body, as cca::body_pose";
      else
        m << "` is none: derive it from `cca::serial_chain<base, tip, cca::axes<...>>`, as in "
             "cca/mapping/serial_chain.hpp";
      return;
    }
    m << "the chain " << type_name<Type>();
    if (!has_joints<Type>)
      m << " has no `joints`: add `static constexpr std::array joints{...};`, with one cca::revolute or "
           "cca::prismatic for each axis";
    if (!has_tip<Type>)
      m << (has_joints<Type> ? " has no `tip`" : "; and no `tip`")
        << ": add `static constexpr cca::placement tip = cca::at(x, y, z);`, its end in the last link";
  }
};

// Stands for a chain that lacks something, so that there is one error.
template <class Type>
struct mended_chain {
  struct nowhere {};
  using base = void;
  using tip_frame = nowhere;
  using axes = cca::axes<>;
  static constexpr std::array<joint, 0> joints{};
  static constexpr placement tip{};
};
template <class Type>
  requires has_ends<Type>
struct mended_chain<Type> : serial_chain<typename Type::base, typename Type::tip_frame, typename Type::axes> {
  static constexpr std::array<joint, 0> joints{};
  static constexpr placement tip{};
};

}  // namespace detail

// A chain with the inertia of its links.
template <class Type> concept DynamicChain = SerialChain<Type> && requires { Type::links.size(); };

namespace detail {

// A joint ready for use: its placement as a matrix (by columns), its axis of length 1, and the link in which
// it is placed (-1: the base).
struct body_link {
  int parent = -1;
  joint_kind kind = joint_kind::revolute;
  int coordinate = 0;
  double ratio = 1, rest = 0;
  int principal = -1;    // 0, 1, 2 for the axes x, y, z; else -1
  bool straight = true;  // the frame of the joint is not rotated against that of its parent
  std::array<double, 3> axis{}, at{};
  std::array<double, 9> turn{};
  link_inertia inertia{};
};

constexpr std::array<double, 9> matrix_of(const std::array<double, 4>& q) {
  const auto a = turned_by(q, along_x), b = turned_by(q, along_y), c = turned_by(q, along_z);
  return {a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]};
}

constexpr body_link body_link_of(
    const joint& j, int index, int parent, const placement& parent_to_base = {}, int first_coordinate = 0) {
  body_link l;
  const placement where = parent_to_base * j.where;
  const double length = constant_root(j.axis[0] * j.axis[0] + j.axis[1] * j.axis[1] + j.axis[2] * j.axis[2]);
  l.parent = parent;
  l.kind = j.kind;
  l.coordinate = first_coordinate + (j.coordinate < 0 ? index : j.coordinate);
  l.ratio = j.ratio;
  l.rest = j.rest;
  for (std::size_t i = 0; i < 3; ++i) {
    l.axis[i] = j.axis[i] / length;
    if (l.axis[i] == 1) l.principal = static_cast<int>(i);
  }
  l.at = where.translation;
  l.turn = matrix_of(where.rotation);
  l.straight = where.rotation[0] == 0 && where.rotation[1] == 0 && where.rotation[2] == 0;
  return l;
}

// The coordinate of an axis by its name; -1: there is no such axis.
template <class... Axes>
constexpr int axis_by_name(axes<Axes...>, std::string_view name) {
  int found = -1, i = 0;
  ((found = Axes::name == name ? i : found, ++i), ...);
  return found;
}

template <std::size_t Count>
constexpr bool are_finite(const std::array<double, Count>& numbers) {
  constexpr double most = std::numeric_limits<double>::max();
  for (const double x : numbers)
    if (!(x >= -most && x <= most)) return false;
  return true;
}
constexpr bool is_sound(const joint& j) {
  return are_finite(j.axis) && are_finite(j.where.translation) && are_finite(j.where.rotation) &&
         are_finite(std::array{j.ratio, j.rest}) && j.axis != std::array<double, 3>{};
}
constexpr bool is_sound(const link_inertia& l) {
  return l.mass >= 0 && are_finite(std::array{l.mass}) && are_finite(l.centre) && are_finite(l.about_centre);
}
// The first joint, or link, whose numbers no robot has; -1: there is none.
template <class Numbers>
constexpr int first_unsound(const Numbers& all) {
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!is_sound(all[i])) return static_cast<int>(i);
  return -1;
}

template <class Chain>
struct unsound_joint {
  static constexpr void tell(text& m) {
    constexpr int i = first_unsound(Chain::joints);
    m << "mapping.bad_chain: joint " << i << " of the chain " << type_name<Chain>() << " has ";
    if (Chain::joints[static_cast<std::size_t>(i)].axis == std::array<double, 3>{})
      m << "the axis (0, 0, 0), which is no direction: give it an axis with a length, such as cca::along_z";
    else
      m << "a number that is not finite: look for a NaN or an overflow in its axis, its placement and its "
           "`driven_by`";
  }
};
template <class Chain>
struct unsound_link {
  static constexpr void tell(text& m) {
    constexpr int i = first_unsound(Chain::links);
    m << "mapping.bad_chain: link " << i << " of the chain " << type_name<Chain>() << " has ";
    if (Chain::links[static_cast<std::size_t>(i)].mass < 0)
      m << "a mass below 0: masses are in kg, and 0 is that of a link without weight";
    else m << "a number that is not finite: look for a NaN or an overflow in its mass, centre and inertia";
  }
};
// A joint of a chain; of one that is refused, what the compiler can go on with.
template <class Chain>
constexpr joint joint_of_chain(std::size_t i) {
  constexpr bool sound = first_unsound(Chain::joints) < 0;
  static_assert(holds_or_tells<sound, unsound_joint<Chain>>::value);
  joint j = Chain::joints[i];
  if (!sound) j.axis = along_z, j.where = {}, j.ratio = 1, j.rest = 0;
  return j;
}

template <class Chain>
struct wrong_link_count {
  static constexpr void tell(text& m) {
    m << "mapping.bad_chain: the chain " << type_name<Chain>() << " has "
      << static_cast<std::int64_t>(Chain::links.size()) << " `links` and "
      << static_cast<std::int64_t>(Chain::joints.size())
      << " `joints`; give the inertia of the link behind each joint, in their order";
  }
};
// Of the link behind a joint; without `links` it weighs nothing.
template <class Chain>
constexpr link_inertia inertia_of_link(std::size_t joint) {
  if constexpr (DynamicChain<Chain>) {
    constexpr bool sound = first_unsound(Chain::links) < 0;
    static_assert(
        holds_or_tells<(Chain::links.size() == Chain::joints.size()), wrong_link_count<Chain>>::value);
    static_assert(holds_or_tells<sound, unsound_link<Chain>>::value);
    if (sound && joint < Chain::links.size()) return Chain::links[joint];
  }
  return {};
}

template <class Chain>
inline constexpr auto chain_links = [] {
  std::array<body_link, Chain::joints.size()> links{};
  for (std::size_t i = 0; i < links.size(); ++i)
    links[i] = body_link_of(joint_of_chain<Chain>(i), static_cast<int>(i), static_cast<int>(i) - 1);
  for (std::size_t i = 0; i < links.size(); ++i)
    if (const auto name = Chain::joints[i].follows; !name.empty())
      links[i].coordinate = axis_by_name(typename Chain::axes(), name);
  for (std::size_t i = 0; i < links.size(); ++i) links[i].inertia = inertia_of_link<Chain>(i);
  return links;
}();

// The first joint without one; -1: there is none.
template <class Chain>
constexpr int undriven_joint = [] {
  const auto& links = chain_links<Chain>;
  for (std::size_t i = 0; i < links.size(); ++i)
    if (links[i].coordinate < 0 || links[i].coordinate >= Chain::axes::count) return static_cast<int>(i);
  return -1;
}();
template <class Chain>
struct chain_without_axis {
  static constexpr void tell(text& m) {
    const auto joint = static_cast<std::size_t>(undriven_joint<Chain>);
    m << "mapping.bad_chain: joint " << undriven_joint<Chain> << " of the chain " << type_name<Chain>()
      << " is driven by ";
    if (const auto name = Chain::joints[joint].follows; !name.empty()) m << "the axis `" << name << "`";
    else m << "coordinate " << chain_links<Chain>[joint].coordinate;
    m << ", and the chain has " << Chain::axes::count << (Chain::axes::count == 1 ? " axis (" : " axes (")
      << axes_in_words<typename Chain::axes>()
      << "), counted from 0: add the axis to the chain, or correct the number or the name in `driven_by`";
  }
};

// The same in a body, where a joint can follow an axis of another part.
template <class Chain>
constexpr int own_coordinate(std::size_t joint) {
  const int stated = Chain::joints[joint].coordinate;
  return stated < 0 ? static_cast<int>(joint) : stated;
}
// The first joint whose coordinate the chain lacks; -1: there is none.
template <class Chain>
constexpr int joint_without_coordinate = [] {
  for (std::size_t i = 0; i < Chain::joints.size(); ++i)
    if (Chain::joints[i].follows.empty() && own_coordinate<Chain>(i) >= Chain::axes::count)
      return static_cast<int>(i);
  return -1;
}();

}  // namespace detail
}  // namespace cca
