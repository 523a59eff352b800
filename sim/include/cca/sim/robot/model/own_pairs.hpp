// Which shapes of a robot may touch each other, if its description says that it touches itself.
//
// Not those of one link, and not those of neighbours: links that have no third one with a shape between them.
// They overlap where the joint is.
#pragma once

#include <array>
#include <cstddef>

#include <cca/robots/description.hpp>

namespace cca::sim::detail {

// `parent_of(link)`: of a link on the base -1.
template <class Shapes, class ParentOf>
constexpr bool may_touch(const Shapes& shapes, std::size_t i, std::size_t j, ParentOf parent_of) {
  constexpr int base = -1;
  const int a = shapes[i].link, b = shapes[j].link;
  const auto is_above = [&](int top, int link) {
    while (link != top && link != base) link = parent_of(link);
    return link == top;
  };
  const auto has_shape = [&](int link) {
    for (const auto& s : shapes)
      if (s.link == link) return true;
    return false;
  };
  int top = a;
  while (!is_above(top, b)) top = parent_of(top);
  if (top != a && top != b && has_shape(top)) return true;
  for (int link : {a, b})
    while (link != top && (link = parent_of(link)) != top)
      if (has_shape(link)) return true;
  return false;
}

// `f(i, j)`, i before j.
template <class Shapes, class ParentOf, class F>
constexpr void each_own_pair(const Shapes& shapes, ParentOf parent_of, F f) {
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (std::size_t j = i + 1; j < shapes.size(); ++j)
      if (may_touch(shapes, i, j, parent_of)) f(i, j);
}

}  // namespace cca::sim::detail
