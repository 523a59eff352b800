// What of a description no compiled world can move, and the sentence that says so. Cost: constants. Errors:
// robot.compiled.
#pragma once

#include <cstddef>
#include <cstdint>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/robots/description.hpp>
#include <cca/sim/compiled/compiled_tree.hpp>

namespace cca::sim::detail {

using cca::detail::type_name;

// The first coordinate that no mass resists; -1: there is none. The links here are reduced: what the joint of
// a link can't feel of it is part of the link before.
template <class R>
constexpr int weightless_coordinate = [] {
  using tree = compiled_tree<R>;
  std::array<bool, static_cast<std::size_t>(tree::coordinates)> resists{};
  for (std::size_t i = 0; i < tree::links; ++i) {
    const auto& own = tree::reduced.links[i];
    const auto& m = own.mass;
    const std::size_t x = (own.axis + 1) % 3, y = (own.axis + 2) % 3;
    if (!(own.revolute ? m.at(x, x) + m.at(y, y) > 0 || m.first[x] != 0 || m.first[y] != 0 : m.mass > 0))
      continue;
    for (int j = static_cast<int>(i); j >= 0; j = tree::reduced.links[static_cast<std::size_t>(j)].parent)
      resists[static_cast<std::size_t>(tree::reduced.links[static_cast<std::size_t>(j)].coordinate)] = true;
  }
  for (std::size_t c = 0; c < resists.size(); ++c)
    if (!resists[c]) return static_cast<int>(c);
  return -1;
}();
template <class R>
struct moves_no_mass {
  static constexpr void tell(auto& m) {
    m << "robot.compiled: the joint `"
      << cca::detail::axis_in_words(axes_of<typename R::body>(), weightless_coordinate<R>) << "` of "
      << type_name<R>()
      << " turns nothing that resists it, so its acceleration has no bound; give a link behind it its "
         "inertia, or a "
         "mass beside the axis";
  }
};

template <class R>
constexpr bool check_compiled() {
  static_assert(robots::check_description<R>());
  static_assert(cca::detail::holds_or_tells<(weightless_coordinate<R> < 0), moves_no_mass<R>>::value);
  return true;
}

}  // namespace cca::sim::detail
