// The state of a compiled world as a value: put it back, and a run goes on bit for bit.
//
// Trivially copyable for a scalar that is.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <cca/sim/compiled/around/surroundings.hpp>
#include <cca/sim/compiled/contacts/contacts.hpp>
#include <cca/sim/compiled/inertial_places.hpp>
#include <cca/sim/compiled/probes.hpp>
#include <cca/sim/compiled/tree_step.hpp>
#include <cca/sim/robot/model/contact_account.hpp>
#include <cca/sim/robot/model/drive_condition.hpp>
#include <cca/sim/robot/model/plausible.hpp>

namespace cca::sim {

template <class Real>
struct compiled_reading {
  Real angle{}, velocity{}, torque{};  // rad, rad/s, N m of the motor, a mean over the beat
};

template <class Real>
struct pull_on_end {
  std::array<Real, 3> force{}, torque{};  // N, N m, along the world's axes
};

namespace detail {

template <std::size_t Shapes>
using shape_accounts = std::array<contact_account, Shapes>;
// Of each lane its own.
template <class Real, std::size_t Shapes>
struct accounts_in_lanes {
  std::array<shape_accounts<Shapes>, static_cast<std::size_t>(Real::count)> of_lane{};
};
template <class Real, std::size_t Shapes, bool HasLanes = is_in_lanes<Real>>
struct accounts_for {
  using type = shape_accounts<Shapes>;
};
template <class Real, std::size_t Shapes>
struct accounts_for<Real, Shapes, true> {
  using type = accounts_in_lanes<Real, Shapes>;
};

}  // namespace detail

// All that a beat of physics depends on, or adds to.
template <class R, class Real>
struct compiled_state {
  using tree = detail::compiled_tree<R>;
  static constexpr auto n = static_cast<std::size_t>(tree::coordinates);

  detail::tree_motion<Real, tree::coordinates, tree::floats> motion{};
  detail::tree_drives<R, Real> drives{};
  std::array<compiled_reading<Real>, n> joints{};
  std::array<drive_condition, n> conditions{};
  std::array<pull_on_end<Real>, tree::described.ends.size()> pulls{};
  std::array<Real, 3> push{};
  typename detail::contacts_in_step<R, Real>::impulses impulses{};  // of the last step's contacts
  detail::motion_around<Real> around{};                             // boxes and balls
  std::array<std::array<Real, 6>, detail::load_parts<R>.size()> loads{};
  std::array<std::array<Real, 3>, tree::described.ends.size()> end_forces{};
  std::array<robots::inertial_reading, detail::inertial_places<R>.size()> inertial{};
  std::array<std::array<double, 3>, detail::inertial_places<R>.size()>
      unit_speeds{};                // m/s, after the last beat
  std::array<double, 3> planned{};  // the push that a plan said last
  typename detail::accounts_for<Real, detail::probes_of<R>::shape_count>::type contacts{};  // of the shapes
  Real positive_work{}, absolute_work{};  // J, of the motors
  std::int64_t beats = 0;
  world_trouble trouble{};
};

}  // namespace cca::sim
