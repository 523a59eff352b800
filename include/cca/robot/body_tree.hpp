// The links of a body in one array, each after the one to which it is attached, and their inertia: constants.
//
// Precondition: the numbers of the body are finite; no input comes here, so no NaN does. Errors:
// body.unknown_axis, body.no_inertia.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include <cca/mapping/serial_chain.hpp>
#include <cca/robot/body.hpp>

namespace cca {
namespace detail {

// The end of a part: its link (-1: the base), and the placement in that link.
struct part_end {
  int link = -1;
  placement where{};
};

// The links of a body in one array, each after the one to which it is attached.
template <std::size_t Links, std::size_t Parts>
struct body_tree {
  std::array<body_link, Links> links{};
  std::array<part_end, Parts> ends{};
};

template <class Axes, class Base, class Chain>
constexpr void attach(Base& tree, std::size_t& used, std::size_t part, int on, int first_coordinate) {
  part_end end = on < 0 ? part_end{} : tree.ends[static_cast<std::size_t>(on)];
  for (std::size_t i = 0; i < Chain::joints.size(); ++i) {
    auto& l = tree.links[used];
    l = body_link_of(joint_of_chain<Chain>(i), static_cast<int>(i), end.link, end.where, first_coordinate);
    if (const auto name = Chain::joints[i].follows; !name.empty()) l.coordinate = axis_by_name(Axes(), name);
    l.inertia = inertia_of_link<Chain>(i);
    end = {static_cast<int>(used++), {}};
  }
  tree.ends[part] = {end.link, end.where * Chain::tip};
}

// Of a body: the first joint of a part that is driven by a coordinate which its chain lacks.
template <class... Parts>
struct unknown_coordinate {
  static constexpr void tell(text& m) { (void)(one<Parts>(m) || ...); }

private:
  template <class Part>
  static constexpr bool one(text& m) {
    using chain = typename Part::chain;
    constexpr int joint = joint_without_coordinate<chain>;
    if constexpr (joint >= 0)
      m << "body.unknown_axis: joint " << joint << " of the part `" << Part::name
        << "` is driven by coordinate " << own_coordinate<chain>(static_cast<std::size_t>(joint))
        << ", and its chain has " << chain::axes::count << (chain::axes::count == 1 ? " axis (" : " axes (")
        << axes_in_words<typename chain::axes>()
        << "), counted from 0: add the axis to the chain, or correct the number in `driven_by`";
    return joint >= 0;
  }
};
// The same of one that follows an axis by its name.
template <class Axes, class... Parts>
struct unknown_followed_axis;
template <class... Axes, class... Parts>
struct unknown_followed_axis<axes<Axes...>, Parts...> {
  static constexpr void tell(text& m) { (void)(one<Parts>(m) || ...); }

private:
  template <class Part>
  static constexpr bool one(text& m) {
    for (std::size_t i = 0; i < Part::chain::joints.size(); ++i) {
      const std::string_view name = Part::chain::joints[i].follows;
      if (name.empty() || axis_by_name(axes<Axes...>(), name) >= 0) continue;
      m << "body.unknown_axis: joint " << static_cast<std::int64_t>(i) << " of the part `" << Part::name
        << "` follows the axis `" << name << "` (`driven_by`), which no part of the body has";
      tell_names(m, name, std::array<std::string_view, sizeof...(Axes)>{Axes::name...});
      return true;
    }
    return false;
  }
};

template <class Body, class Parts>
struct tree_facts;
template <class Body, class... Parts>
struct tree_facts<Body, std::tuple<Parts...>> {
  static constexpr std::size_t count = sizeof...(Parts), links = (Parts::chain::joints.size() + ... + 0u);
  static_assert(holds_or_tells<((joint_without_coordinate<typename Parts::chain> < 0) && ...),
                               unknown_coordinate<Parts...>>::value);

  static constexpr auto value = [] {
    body_tree<links, count> tree;
    std::array<bool, count> done{};
    std::size_t used = 0;
    for (std::size_t round = 0; round < count; ++round) {
      std::size_t i = 0;
      int first = 0;
      const auto add = [&]<class Part>(std::type_identity<Part>) {
        const int on = Body::attached::parent[i];
        if (!done[i] && (on < 0 || done[static_cast<std::size_t>(on)])) {
          attach<typename Body::axes, decltype(tree), typename Part::chain>(tree, used, i, on, first);
          done[i] = true;
        }
        ++i;
        first += Part::chain::axes::count;
      };
      (add(std::type_identity<Parts>()), ...);
    }
    return tree;
  }();

  static constexpr bool axes_exist = [] {
    for (const body_link& l : value.links)
      if (l.coordinate < 0) return false;
    return true;
  }();
  static_assert(holds_or_tells<axes_exist, unknown_followed_axis<typename Body::axes, Parts...>>::value);
};

template <class Body>
inline constexpr const auto& body_tree_of = tree_facts<Body, typename Body::parts>::value;

template <class Body>
struct body_without_mass {
  static constexpr void tell(text& m) {
    m << "body.no_inertia: no link of the body " << type_name<Body>()
      << " has a mass, so it has no dynamics, only kinematics; give its chains the inertia of each link, "
         "`links`";
  }
};

// The same links, for dynamics.
template <class Body>
struct weighed {
  static constexpr const auto& links = body_tree_of<Body>.links;
  static constexpr bool has_inertia = [] {
    for (const body_link& l : links)
      if (l.inertia.mass > 0) return true;
    return links.empty();
  }();
  static_assert(holds_or_tells<has_inertia, body_without_mass<Body>>::value);
};
template <class Body>
inline constexpr const auto& weighed_links_of = weighed<Body>::links;

template <class Body>
constexpr link_inertia base_inertia_of() {
  if constexpr (requires { Body::base.mass; }) return Body::base;
  else return {};
}

}  // namespace detail
}  // namespace cca
