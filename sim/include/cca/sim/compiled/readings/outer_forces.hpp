// The forces that the program sets in a compiled world: pulls at the ends of parts, a push on the base.
#pragma once

#include <array>
#include <cstddef>

#include <cca/sim/compiled/compiled_state.hpp>
#include <cca/sim/compiled/on_links.hpp>
#include <cca/sim/compiled/tree_step.hpp>

namespace cca::sim::detail {

template <class R, class Real>
constexpr void pull_and_push(const compiled_state<R, Real>& state, tree_step<R, Real>& now) {
  using tree = compiled_tree<R>;
  using links = on_links<R, Real>;
  const auto given = [&](const std::array<Real, 3>& v) {
    return along(now.base, triple<Real>{v[0], v[1], v[2]});
  };
  for (std::size_t part = 0; part < state.pulls.size(); ++part) {
    const auto& e = tree::described.ends[part];
    const auto& [force, torque] = state.pulls[part];
    if (is_none(force) && is_none(torque)) continue;
    const triple<Real> at = links::point(now.now.places(), e.link, tree::point({e.link, e.where}));
    links::add_wrench(now.now.places(), e.link, at, given(force), given(torque), now.now.forces);
  }
  constexpr auto c = cca::detail::base_inertia_of<typename R::body>().centre;
  if (tree::floats && !is_none(state.push))
    links::add_wrench(now.now.places(), -1, {Real(c[0]), Real(c[1]), Real(c[2])}, given(state.push), {},
                      now.now.forces);
}

}  // namespace cca::sim::detail
