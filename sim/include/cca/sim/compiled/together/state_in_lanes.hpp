// The state of worlds in lanes: taken from worlds, and given back.
//
// Taken is what a beat depends on; given back, what it changes.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <tuple>

#include <cca/sim/compiled/compiled_state.hpp>
#include <cca/sim/compiled/lanes/lanes.hpp>

namespace cca::sim::detail {

// `f(a number of `many`, the same of `one`)`: of all numbers of a motion.
template <class Many, class One, class F>
void each_number_of_motion(Many& many, One& one, F f) {
  const auto vector = [&](auto& a, auto& b) {
    for (std::size_t k = 0; k < 3; ++k) f(a[k], b[k]);
  };
  const auto all = [&](auto& a, auto& b) {
    for (std::size_t k = 0; k < a.size(); ++k) f(a[k], b[k]);
  };
  vector(many.at, one.at), all(many.attitude.q, one.attitude.q);
  vector(many.angular_velocity, one.angular_velocity), vector(many.velocity, one.velocity);
  all(many.q, one.q), all(many.dq, one.dq);
  vector(many.change.turning, one.change.turning), all(many.change.joints, one.change.joints);
  vector(many.change_before.turning, one.change_before.turning);
  all(many.change_before.joints, one.change_before.joints);
}
// The motion in a lane.
template <class Motion, class Many>
Motion motion_of_lane(const Many& many, int k) {
  Motion one;
  each_number_of_motion(many, one, [k](const auto& a, double& b) { b = a[k]; });
  return one;
}

template <class R, int N>
struct state_in_lanes {
  using real = lanes<N>;
  using many = compiled_state<R, real>;
  using one = compiled_state<R, double>;
  static constexpr std::size_t room_alone = std::tuple_size_v<decltype(one{}.impulses.keys)>;  // of contacts

  // `laws`: asked for in this beat. Lanes are taken in their order.
  static void take(many& to, int k, const one& from, std::span<const joint_law> laws) {
    const auto set = [k](real& a, double b) { a.set(k, b); };
    each_number_of_motion(to.motion, from.motion, set);
    auto& d = to.drives;
    std::array<joint_law, one::n> own = from.drives.laws;
    take_laws(laws, own);
    for (std::size_t c = 0; c < one::n; ++c) {
      set(d.laws[c].position, own[c].position), set(d.laws[c].velocity, own[c].velocity);
      set(d.laws[c].torque, own[c].torque), set(d.laws[c].stiffness, own[c].stiffness);
      set(d.laws[c].damping, own[c].damping);
      if (!winds(c)) continue;
      const auto& p = from.drives.pulleys[c];
      set(d.pulleys[c].wound, p.wound), set(d.pulleys[c].speed, p.speed), set(d.pulleys[c].torque, p.torque);
    }
    for (std::size_t part = 0; part < to.pulls.size(); ++part)
      for (std::size_t r = 0; r < 3; ++r) {
        set(to.pulls[part].force[r], from.pulls[part].force[r]);
        set(to.pulls[part].torque[r], from.pulls[part].torque[r]);
      }
    for (std::size_t r = 0; r < 3; ++r) set(to.push[r], from.push[r]);
    take_impulses(to, k, from);
    to.contacts.of_lane[static_cast<std::size_t>(k)] = from.contacts;
    set(to.positive_work, from.positive_work), set(to.absolute_work, from.absolute_work);
  }

  static void give(const many& from, int k, one& to, std::span<const joint_law> laws) {
    const auto get = [k](const real& a, double& b) { b = a[k]; };
    each_number_of_motion(from.motion, to.motion, get);
    auto& d = to.drives;
    take_laws(laws, d.laws);
    for (std::size_t c = 0; c < one::n; ++c) {
      get(from.drives.torque[c], d.torque[c]);
      get(from.joints[c].angle, to.joints[c].angle), get(from.joints[c].velocity, to.joints[c].velocity);
      get(from.joints[c].torque, to.joints[c].torque);
      auto& p = d.pulleys[c];
      if (!winds(c)) {
        p.wanted = (1 / beat) * (d.laws[c].position - p.wound);
        continue;
      }
      const auto& of = from.drives.pulleys[c];
      get(of.wound, p.wound), get(of.wanted, p.wanted), get(of.speed, p.speed), get(of.torque, p.torque);
    }
    for (std::size_t i = 0; i < to.loads.size(); ++i)
      for (std::size_t r = 0; r < 6; ++r) get(from.loads[i][r], to.loads[i][r]);
    for (std::size_t i = 0; i < to.end_forces.size(); ++i)
      for (std::size_t r = 0; r < 3; ++r) get(from.end_forces[i][r], to.end_forces[i][r]);
    give_impulses(from, k, to);
    to.contacts = from.contacts.of_lane[static_cast<std::size_t>(k)];
    get(from.positive_work, to.positive_work), get(from.absolute_work, to.absolute_work);
  }

private:
  static constexpr double beat = 1 / cca::detail::hz_of<typename R::rate>;
  static constexpr bool winds(std::size_t c) { return R::drives[c].cable.stiffness > 0; }

  // A contact that a lane has not had gives no impulse there: as one that is not found.
  static void take_impulses(many& to, int k, const one& from) {
    auto& all = to.impulses;
    if (k == 0) all.count = 0;
    for (std::size_t i = 0; i < from.impulses.count; ++i) {
      const int key = from.impulses.keys[i];
      std::size_t at = 0;
      while (at < all.count && all.keys[at] != key) ++at;
      if (at == all.keys.size()) continue;
      if (at == all.count) ++all.count, all.keys[at] = key, all.impulses[at] = {};
      set_lane(all.impulses[at], k, from.impulses.impulses[i]);
    }
  }
  static void give_impulses(const many& from, int k, one& to) {
    auto& own = to.impulses;
    own.count = 0;
    for (std::size_t i = 0; i < from.impulses.count && own.count < own.keys.size(); ++i) {
      const triple<double> p = lane_of(from.impulses.impulses[i], k);
      if (p[0] == 0 && p[1] == 0 && p[2] == 0) continue;
      own.keys[own.count] = from.impulses.keys[i], own.impulses[own.count++] = p;
    }
  }
};

}  // namespace cca::sim::detail
