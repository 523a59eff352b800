// The position of all parts of a body: forward kinematics, Jacobians and the centre of mass, in the frame of
// the base of the body.
//
//   const cca::body_pose<oncilla_body> now(q);        q over axes_of<oncilla_body>, rad (prismatic: m)
//   now.tip<"left_front_leg">()                       position and orientation of the end of the part
//   now.jacobian<"left_front_leg">()                  6 x coordinates: angular velocity, then velocity of the
//                                                     origin of that end
//   now.centre_of_mass()                              of all links and the base, m
//
// An angle that is NaN or infinite makes each link behind it and the centre of mass not finite; nothing is
// kept.
// Everything has fixed size; nothing allocates. Cost: per joint a sine, a cosine and at most two products of
// 3 x 3 matrices.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include <cca/mapping/kinematics.hpp>
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
    l = body_link_of(Chain::joints[i], static_cast<int>(i), end.link, end.where, first_coordinate);
    if (const auto name = Chain::joints[i].follows; !name.empty()) l.coordinate = axis_by_name(Axes(), name);
    l.inertia = inertia_of_link<Chain>(i);
    end = {static_cast<int>(used++), {}};
  }
  tree.ends[part] = {end.link, end.where * Chain::tip};
}

template <class Body, class Parts>
struct tree_facts;
template <class Body, class... Parts>
struct tree_facts<Body, std::tuple<Parts...>> {
  static constexpr std::size_t count = sizeof...(Parts), links = (Parts::chain::joints.size() + ... + 0u);
  static_assert((own_coordinates_exist<typename Parts::chain> && ...),
                "body.unknown_axis: a joint of this body is driven by a coordinate for which its chain has "
                "no axis; add the axis to the chain, or correct the number in `driven_by`, which counts "
                "the axes of the chain from 0");

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
  static_assert(axes_exist,
                "body.unknown_axis: a joint of this body follows an axis that no part of the body has; "
                "correct the name "
                "in `driven_by`, or add the part that has this axis");
};

template <class Body>
inline constexpr const auto& body_tree_of = tree_facts<Body, typename Body::parts>::value;

// The same links, for dynamics.
template <class Body>
struct weighed {
  static constexpr const auto& links = body_tree_of<Body>.links;
  static constexpr bool has_inertia = [] {
    for (const body_link& l : links)
      if (l.inertia.mass > 0) return true;
    return links.empty();
  }();
  static_assert(has_inertia,
                "body.no_inertia: no link of this body has a mass, so it has no dynamics, only kinematics; "
                "give its chains the inertia of each link, `links`");
};
template <class Body>
inline constexpr const auto& weighed_links_of = weighed<Body>::links;

template <class Body>
constexpr link_inertia base_inertia_of() {
  if constexpr (requires { Body::base.mass; }) return Body::base;
  else return {};
}

// The common centre of mass of all links and the base.
template <std::size_t Count>
vector3 centre_of_mass(const std::array<body_link, Count>& links,
                       const std::array<placed_link, Count>& placed,
                       const link_inertia& base) {
  double mass = base.mass;
  vector3 moment = base.mass * as_vector(base.centre);
  for (std::size_t i = 0; i < Count; ++i) {
    const auto& [m, centre, inertia] = links[i].inertia;
    mass += m;
    moment += m * (placed[i].frame.at + placed[i].frame.turn * as_vector(centre));
  }
  return mass > 0 ? vector3(moment / mass) : vector3::Zero();
}

}  // namespace detail

template <Body Type>
class body_pose {
  static constexpr const auto& tree = detail::body_tree_of<Type>;
  static constexpr std::size_t count = tree.links.size();

public:
  static constexpr int size = axes_of<Type>::count;
  using vector_type = Eigen::Matrix<double, size, 1>;
  using jacobian_type = Eigen::Matrix<double, 6, size>;

  explicit body_pose(const vector_type& q) { detail::place_links(tree.links, q, placed); }

  template <fixed_string Part>
  rigid tip() const {
    return end(number<Part>());
  }

  template <fixed_string Part>
  jacobian_type jacobian() const {
    constexpr std::size_t i = number<Part>();
    jacobian_type j;
    detail::fill_jacobian(tree.links, placed, tree.ends[i].link, end(i).at, j);
    return j;
  }

  // Parts count in order of declaration.
  rigid end(std::size_t part) const {
    const auto& e = tree.ends[part];
    return (e.link < 0 ? rigid{} : placed[static_cast<std::size_t>(e.link)].frame) * e.where;
  }

  Eigen::Matrix<double, 3, 1> centre_of_mass() const {
    return detail::centre_of_mass(tree.links, placed, detail::base_inertia_of<Type>());
  }

  // Used by body_dynamics.hpp.
  const auto& links() const { return placed; }

private:
  template <fixed_string Part>
  static constexpr std::size_t number() {
    constexpr int i = part_index<Type>(Part.view());
    static_assert(i >= 0,
                  "body.unknown_part: this body has no part with that name; the names are those in "
                  "cca::part<name, chain>");
    return i < 0 ? 0 : static_cast<std::size_t>(i);
  }

  std::array<detail::placed_link, count> placed;
};

}  // namespace cca
