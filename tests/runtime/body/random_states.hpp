// Random states of random trees, and what the library makes of them.
#pragma once

#include <array>
#include <cstddef>

#include "random_trees.hpp"

namespace body_test {

template <std::size_t Count>
using state = Eigen::Matrix<double, static_cast<int>(Count), 1>;

template <std::size_t Count>
state<Count> random_state(laws::source& random, double size) {
  state<Count> v;
  for (auto& x : v) x = random(-size, size);
  return v;
}

template <std::size_t Count>
auto placed(const random_tree<Count>& t, const state<Count>& q) {
  std::array<cca::detail::placed_link, Count> links;
  cca::detail::place_links(t.links, q, links);
  return links;
}

// From KDL's order to ours.
template <std::size_t Count>
state<Count> in_order(const random_tree<Count>& t, const KDL::JntArray& a) {
  state<Count> v;
  for (std::size_t i = 0; i < Count; ++i)
    v[static_cast<Eigen::Index>(i)] = a(static_cast<unsigned>(t.number(i)));
  return v;
}

// The slope of f at 0, to the sixth order.
template <class Function>
auto slope(Function f, double h = 2e-3) {
  return ((45 * (f(h) - f(-h)) - 9 * (f(2 * h) - f(-2 * h)) + (f(3 * h) - f(-3 * h))) / (60 * h)).eval();
}

}  // namespace body_test
