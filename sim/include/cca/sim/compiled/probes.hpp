// The points with which a described robot touches the ground in a compiled world: a sphere is one with a
// radius, a capsule two, a box its eight corners. Boxes and balls touch the shapes as they are (touches.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include <cca/sim/compiled/compiled_tree.hpp>
#include <cca/sim/robot/model/own_pairs.hpp>
#include <cca/sim/robot/model/robot_model.hpp>

namespace cca::sim::detail {

// The part of each force sensor.
template <class R>
constexpr auto load_parts = []<class... Sensors>(robots::sensors<Sensors...>) {
  std::array<int, robots::detail::load_count(robots::sensors<Sensors...>())> all{};
  [[maybe_unused]] std::size_t n = 0;
  [[maybe_unused]] const auto add = [&](bool is_load, std::string_view part) {
    if (is_load) all[n++] = part_index<typename R::body>(part);
  };
  (add(robots::is_load<Sensors>, Sensors::part.view()), ...);
  return all;
}(robots::sensors_of<R>());

struct probe {
  int link = -1, shape = 0;    // -1: the base
  int tip = -1;                // the last row that moves it; -1: none does
  std::array<double, 3> at{};  // in the frame of the reduced link
  double radius = 0;
};

template <class R>
struct probes_of {
  using tree = compiled_tree<R>;
  static constexpr std::size_t shape_count = [] {
    if constexpr (requires { R::shapes.size(); }) return R::shapes.size();
    else return std::size_t{0};
  }();
  static constexpr auto shapes = [] {
    std::array<placed_shape, shape_count> all{};
    if constexpr (shape_count > 0) {
      using body = typename R::body;
      constexpr auto parts = links_by_part<body>();
      constexpr auto ends = ends_of<body>();
      for (std::size_t i = 0; i < shape_count; ++i)
        all[i] = placed(R::shapes[i], part_index<body>(R::shapes[i].part), parts, ends, std::array<int, 0>{});
    }
    return all;
  }();

  static constexpr int corners(const placed_shape& s) {
    return s.form.kind == robots::shape_kind::box ? 8 : s.form.kind == robots::shape_kind::capsule ? 2 : 1;
  }
  static constexpr placement corner(const placed_shape& s, int k) {
    const auto& size = s.form.size;
    const auto half = [&](int bit, double whole) { return k >> bit & 1 ? whole / 2 : -whole / 2; };
    if (s.form.kind == robots::shape_kind::box)
      return s.where * cca::at(half(0, size[0]), half(1, size[1]), half(2, size[2]));
    if (s.form.kind == robots::shape_kind::capsule) return s.where * cca::at(0, 0, half(0, size[1]));
    return s.where;
  }
  // A base that is held moves with nothing.
  static constexpr bool moves(const placed_shape& s) { return tree::floats || s.link >= 0; }

  // Whether it may touch an edge with its middle.
  static constexpr bool is_long(const placed_shape& s) { return s.form.kind != robots::shape_kind::sphere; }
  static constexpr std::size_t long_shapes = [] {
    std::size_t n = 0;
    for (const placed_shape& s : shapes)
      if (moves(s) && is_long(s)) ++n;
    return n;
  }();

  static constexpr std::size_t count = [] {
    std::size_t n = 0;
    for (const placed_shape& s : shapes)
      if (moves(s)) n += static_cast<std::size_t>(corners(s));
    return n;
  }();
  static constexpr auto all = [] {
    std::array<probe, count> found{};
    std::size_t n = 0;
    for (std::size_t i = 0; i < shape_count; ++i) {
      const placed_shape& s = shapes[i];
      if (!moves(s)) continue;
      probe p{.link = s.link, .shape = static_cast<int>(i), .tip = tree::base - 1};
      for (int j = s.link; j >= 0; j = tree::reduced.links[static_cast<std::size_t>(j)].parent) {
        const int c = tree::base + tree::reduced.links[static_cast<std::size_t>(j)].coordinate;
        const int row = tree::branches.row[static_cast<std::size_t>(c)];
        if (row > p.tip) p.tip = row;
      }
      if (s.form.kind != robots::shape_kind::box) p.radius = s.form.size[0];
      for (int k = 0; k < corners(s); ++k) {
        p.at = tree::point({s.link, corner(s, k)});
        found[n++] = p;
      }
    }
    return found;
  }();
  // Of each shape that moves: its first probe.
  static constexpr auto first = [] {
    std::array<std::size_t, shape_count> found{};
    for (std::size_t i = count; i-- > 0;) found[static_cast<std::size_t>(all[i].shape)] = i;
    return found;
  }();
  // Of a robot that touches itself: the shapes that may touch each other.
  static constexpr bool touches_itself = robots::touches_itself<R>;
  static constexpr auto own_pairs = [] {
    constexpr auto each = [](auto f) {
      if (touches_itself)
        each_own_pair(
            shapes, [](int link) { return tree::reduced.links[static_cast<std::size_t>(link)].parent; }, f);
    };
    constexpr std::size_t n = [each] {
      std::size_t pairs = 0;
      each([&](std::size_t, std::size_t) { ++pairs; });
      return pairs;
    }();
    std::array<std::array<std::size_t, 2>, n> found{};
    std::size_t k = 0;
    each([&](std::size_t i, std::size_t j) { found[k++] = {i, j}; });
    return found;
  }();
  // The radius of a sphere about the middle of a shape that holds it.
  static constexpr double reach(const placed_shape& s) {
    const auto& size = s.form.size;
    if (s.form.kind == robots::shape_kind::box) return (size[0] + size[1] + size[2]) / 2;
    return size[0] + (s.form.kind == robots::shape_kind::capsule ? size[1] / 2 : 0);
  }
  // The longest branch that moves a probe, in rows.
  static constexpr std::size_t longest = [] {
    int most = 0;
    for (const probe& p : all)
      if (p.tip >= 0 && tree::branches.depth[static_cast<std::size_t>(p.tip)] + 1 > most)
        most = tree::branches.depth[static_cast<std::size_t>(p.tip)] + 1;
    return static_cast<std::size_t>(most);
  }();
};

}  // namespace cca::sim::detail
