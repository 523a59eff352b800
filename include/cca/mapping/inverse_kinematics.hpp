// Inverse kinematics as a component: the joint angles that bring the tip of a chain to a target.
//
//   cca::node<"ik", cca::inverse_kinematics<leg, leg_angles, paw_in_trunk>>
//
//   in  "position"     Tip              the target, in the frame of the chain's base, m; its name is
//                                       "orientation" or "pose" if Tip is such a space
//   in  "near"         Joints           rad, optional: where the search begins; else at the last answer
//   out "angles"       Joints           rad (prismatic joints: m), within the limits of the axes
//   out "status"       reaching_status  a cca::reaching
//
// The angles are always finite and within the limits; that of a continuous axis is the one nearest to where
// the search began, whole turns apart. A cca::pantograph_leg is solved in closed form, in one beat. Every
// other chain is solved by damped least squares from many starts (many_starts.hpp); the fourth argument holds
// the settings. A beat takes at most `steps_per_beat` steps (100), and a longer search goes on in the next
// ones. Until it ends the status is `unfinished`, and the angles lead to the nearest point so far: they may
// jump when a better start is found. A target out of reach gives the angles of the nearest point and
// `nearest`, after `starts` descents (128). A target that is not finite gives the last angles and
// `unreadable`.
//
// While a search goes on, `near` is not read again. A component fires when an input is fresh: if the target
// is published more rarely than the search takes, give the node `cca::timed<1>`.
//
// Errors: frame.mismatch, space.mismatch. Cost: that of the solver; docs/mappings.md has figures.
// Example: tests/runtime/mapping/kinematics.cpp.
#pragma once

#include <string>
#include <tuple>

#include <cca/mapping/many_starts.hpp>
#include <cca/mapping/pantograph.hpp>
#include <cca/space/methods/circle.hpp>

namespace cca {
namespace detail {

template <class Chain, class Joints, class Tip, class Settings>
struct solver_of {
  using type = many_starts<Chain, Joints, Tip, Settings>;
};

// The closed form fits positions only: with two joints over x and z, if the plane of the leg is that of the
// base's x and z; with three joints over x, y and z.
template <PantographLeg Leg, class Joints, class Tip, class Settings>
  requires(same_kind<typename Tip::domain, cartesian_position<void>> &&
           ((Leg::axes::count == 2 && std::is_same_v<typename Tip::axes, axes<x, z>> &&
             Leg::geometry.hip.rotation[0] == 0 && Leg::geometry.hip.rotation[2] == 0) ||
            (Leg::axes::count == 3 && std::is_same_v<typename Tip::axes, axes<x, y, z>>)))
struct solver_of<Leg, Joints, Tip, Settings> {
  using type = pantograph_solver<Leg, Joints, Tip, Settings>;
};

template <class Chain, class Joints>
struct angles_of_other_axes {
  static constexpr void tell(text& m) {
    m << "space.mismatch: the angles of this inverse kinematics are " << space_in_words<Joints>()
      << ", but have exactly the axes of the chain " << type_name<Chain>() << ", "
      << axes_in_words<typename Chain::axes>() << ", all of them and no others";
  }
};
template <class Chain, class Joints>
constexpr auto check_joints() {
  static_assert(holds_or_tells<MovedBy<Chain, Joints>, angles_of_other_axes<Chain, Joints>>::value);
}

}  // namespace detail

template <class Chain, class Joints, class Tip, class Settings = damped_least_squares>
class inverse_kinematics {
  using solver = typename detail::solver_of<Chain, Joints, Tip, Settings>::type;
  using limits = detail::chain_limits<Chain, Joints>;
  using order = detail::reordered<typename Chain::axes, Joints>;
  using vector = typename solver::vector;

public:
  using checked = decltype(detail::check_tip<Chain, Tip>());
  using checked_too = decltype(detail::check_joints<Chain, Joints>());

  auto process(in<detail::tip_port<Tip>(), Tip> wanted, optional_in<"near", Joints> near)
      -> std::tuple<out<"angles", Joints>, out<"status", reaching_status>> {
    auto target = wanted.vector();
    if (!detail::readable<Tip>(target, limits::span)) {
      ++missed.unreadable;
      return {order::to(last), status_of(reaching::unreadable)};
    }
    if (near) {
      const vector start = order::from(near.vector());
      for (int i = 0; i < vector::RowsAtCompileTime; ++i)
        if (std::isfinite(start[i])) last[i] = limits::clamped(i, start[i]);
    }
    const auto found = search.solve(target, last);
    for (int i = 0; i < vector::RowsAtCompileTime; ++i)
      last[i] = limits::is_continuous(i) ? detail::same_turn(found.q[i], last[i]) : found.q[i];
    if (found.status != reaching::reached) [[unlikely]]
      missed.add(found.status, distance_of(found));
    return {order::to(last), status_of(found.status)};
  }

  void on_start() {
    last = limits::clamped(vector(vector::Zero()));
    search = solver();
    missed = {};
  }
  std::string summary() const { return missed.summary(); }

private:
  double distance_of([[maybe_unused]] const auto& found) const {
    if constexpr (requires { found.distance; }) return found.distance;
    else return search.distance();
  }

  vector last = limits::clamped(vector(vector::Zero()));
  [[no_unique_address]] solver search{};
  detail::reaching_counts missed{};
};
template <class Type, class Joints, class Tip, class Settings>
  requires(!SerialChain<Type>)
class inverse_kinematics<Type, Joints, Tip, Settings>
    : public inverse_kinematics<detail::mended_chain<Type>, Joints, Tip, Settings> {
  static_assert(detail::holds_or_tells<false, detail::no_chain<Type>>::value);
};

}  // namespace cca
