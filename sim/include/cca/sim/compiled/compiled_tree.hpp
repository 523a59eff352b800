// What a described robot is to a compiled world: constants.
//
// Points of the description are given in the frames of the reduced body here
// (cca/robot/recorded/reduced_body.hpp), in which the world computes.
#pragma once

#include <array>
#include <cstddef>

#include <cca/robots/description.hpp>
#include <cca/sim/compiled/branches.hpp>
#include <cca/sim/compiled/joint_forces.hpp>
#include <cca/sim/robot/model/robot_model.hpp>

namespace cca::sim::detail {

// A spring or a cable between two points, and the joints that change its length: those between its ends.
template <std::size_t Links>
struct line_in_tree {
  int from = -1, to = -1;
  std::array<double, 3> from_at{}, to_at{};
  double stiffness = 0, rest = 0, damping = 0;
  bool only_pulls = false;
  std::array<int, Links> side{};        // of each link: 1 it moves `to`, -1 `from`, 0 neither or both
  std::array<int, Links> coordinate{};  // those of these links, ascending
  int count = 0;                        // of them

  constexpr bool moves_with(int c) const {
    for (int k = 0; k < count; ++k)
      if (coordinate[static_cast<std::size_t>(k)] == c) return true;
    return false;
  }
};

template <class R>
struct compiled_tree {
  using body = typename R::body;
  static constexpr const auto& reduced = cca::detail::reduced_body_of<body>;
  static constexpr const auto& described = cca::detail::body_tree_of<body>;
  static constexpr bool floats = robots::floats<R>;
  static constexpr int base = floats ? 6 : 0, coordinates = axes_of<body>::count, size = base + coordinates;
  static constexpr std::size_t links = reduced.links.size();

  // Of a base that is held: it belongs to the world, not to the robot.
  static constexpr link_inertia held = floats ? link_inertia{} : cca::detail::base_inertia_of<body>();
  static constexpr double mass = [] {
    double sum = reduced.base.mass - held.mass;
    for (const auto& l : reduced.links) sum += l.mass.mass;
    return sum;
  }();

  // In the frame of the reduced link.
  static constexpr std::array<double, 3> point(const place_on_link& p) {
    auto v = p.where.translation;
    if (p.link < 0) return v;
    const auto i = static_cast<std::size_t>(p.link);
    for (std::size_t k = 0; k < 3; ++k) v[k] -= reduced.shift[i][k];
    return cca::detail::product(cca::detail::transposed(reduced.own[i]), v);
  }

  static constexpr auto lines = [] {
    if constexpr (requires { R::line_springs.size(); }) {
      std::array<line_in_tree<links>, R::line_springs.size()> all{};
      constexpr auto parts = links_by_part<body>();
      constexpr auto ends = ends_of<body>();
      for (std::size_t i = 0; i < all.size(); ++i) {
        const robots::line_spring& s = R::line_springs[i];
        const place_on_link a = placed<body>(s.from, parts, ends), b = placed<body>(s.to, parts, ends);
        all[i] = {a.link,       b.link, point(a), point(b), s.stiffness, s.rest, s.damping,
                  s.only_pulls, {},     {},       0};
        for (int j = b.link; j >= 0; j = reduced.links[static_cast<std::size_t>(j)].parent)
          ++all[i].side[static_cast<std::size_t>(j)];
        for (int j = a.link; j >= 0; j = reduced.links[static_cast<std::size_t>(j)].parent)
          --all[i].side[static_cast<std::size_t>(j)];
        for (int c = 0; c < coordinates; ++c) {
          bool moves = false;
          for (std::size_t j = 0; j < links; ++j)
            if (all[i].side[j] != 0 && reduced.links[j].coordinate == c) moves = true;
          if (moves) all[i].coordinate[static_cast<std::size_t>(all[i].count++)] = c;
        }
      }
      return all;
    } else {
      return std::array<line_in_tree<links>, 0>{};
    }
  }();

  static constexpr auto branches = branches_of<floats, size>(reduced, [](int c, int d) {
    for (const auto& l : lines)
      if (l.moves_with(c) && l.moves_with(d)) return true;
    return false;
  });

  template <class... Axes>
  static constexpr std::array<joint_range, sizeof...(Axes)> ranges_of(axes<Axes...>) {
    return {
        joint_range{cca::detail::lower_limit_of<Axes, angle>, cca::detail::upper_limit_of<Axes, angle>}...};
  }
  static constexpr auto ranges = [] {
    auto all = ranges_of(axes_of<body>());
    for (std::size_t c = 0; c < all.size(); ++c)
      if (!R::drives[c].stops || !all[c].exists()) all[c] = {};
    return all;
  }();
};

}  // namespace cca::sim::detail
