// What a contact of a compiled world's step adds to the readings: the forces at the ends of parts, the force
// sensors, the account of its shape.
#pragma once

#include <cstddef>

#include <cca/sim/compiled/compiled_state.hpp>
#include <cca/sim/compiled/contacts/contacts.hpp>
#include <cca/sim/compiled/on_links.hpp>
#include <cca/sim/compiled/tree_step.hpp>

namespace cca::sim::detail {

template <std::size_t Shapes>
void begin_step(shape_accounts<Shapes>& all) {
  for (contact_account& a : all) a.begin_step();
}
template <class Real, std::size_t Shapes>
void begin_step(accounts_in_lanes<Real, Shapes>& all) {
  for (auto& own : all.of_lane) begin_step(own);
}
// Accounts are plain numbers: of a scalar with more than a number (ground.hpp), that number.
template <class Real, std::size_t Shapes>
void add_to(shape_accounts<Shapes>& all, const contact_force<Real>& c, double step) {
  const Real into = larger(dot(c.force, c.normal), Real(0.0));
  all[static_cast<std::size_t>(c.shape)].add(plain(into), plain(c.speed), plain(c.lost), step);
}
template <class Real, std::size_t Shapes>
void add_to(accounts_in_lanes<Real, Shapes>& all, const contact_force<Real>& c, double step) {
  const Real into = larger(dot(c.force, c.normal), Real(0.0));
  for (int k = 0; k < Real::count; ++k)
    if (c.depth[k] > 0)
      all.of_lane[static_cast<std::size_t>(k)][static_cast<std::size_t>(c.shape)].add(into[k], c.speed[k],
                                                                                      c.lost[k], step);
}

// `share`: of the step in the beat.
template <class R, class Real>
void feel(const tree_step<R, Real>& now,
          const contact_force<Real>& c,
          const Real& share,
          compiled_state<R, Real>& state) {
  using tree = compiled_tree<R>;
  const placed_shape& s = probes_of<R>::shapes[static_cast<std::size_t>(c.shape)];
  if (s.end < 0) return;
  auto& force = state.end_forces[static_cast<std::size_t>(s.end)];
  for (std::size_t k = 0; k < 3; ++k) force[k] = force[k] + share * c.force[k];
  for (std::size_t i = 0; i < state.loads.size(); ++i) {
    if (load_parts<R>[i] != s.end) continue;
    const auto& e = tree::described.ends[static_cast<std::size_t>(s.end)];
    const auto f = on_links<R, Real>::end_frame(now.now.places(), {e.link, e.where});
    const triple<Real> given = along(now.base, c.force), arm = along(now.base, c.at - now.base.at) - f.at;
    const triple<Real> torque = along(f, cross(arm, given)), own = along(f, given);
    for (std::size_t k = 0; k < 3; ++k) {
      state.loads[i][k] = state.loads[i][k] + share * torque[k];
      state.loads[i][3 + k] = state.loads[i][3 + k] + share * own[k];
    }
  }
}

}  // namespace cca::sim::detail
