// The dynamics of a limb alone: where its links are, and what it adds to M and to the forces. As an algorithm
// over any scalar, and as a recording.
//
// Along the axes of the base. `up`: gravity taken from the acceleration of the base. Sources:
// newton_euler.hpp and composite_bodies.hpp in cca/robot/recorded.
#pragma once

#include <array>
#include <cstddef>

#include <cca/base/recording/tape.hpp>
#include <cca/robot/recorded/placed_ends.hpp>
#include <cca/sim/compiled/limbs/limbs.hpp>
#include <cca/sim/compiled/tree_motion.hpp>

namespace cca::sim::detail {

// What a limb does to the base: the load that its motion takes, and its mass moments in this posture.
template <class S>
struct load_of_limb {
  cca::detail::link_load<S> load{};
  std::array<S, 6> turning{};  // moments of inertia about the base's origin: xx, xy, yy, xz, yz, zz
  triple<S> first{};
};

template <class Limb, class S>
struct limb_dynamics {
  std::array<placed_frame<S>, Limb::links> frames{};
  std::array<S, Limb::n> bias{};
  std::array<S, Limb::entries> entries{};
  load_of_limb<S> at_base{};

  // `values`: cosines, then sines.
  template <class Values>
  static constexpr limb_dynamics of(const Values& values,
                                    const std::array<S, Limb::n>& speeds,
                                    const triple<S>& turning,
                                    const triple<S>& up) {
    constexpr bool floats = Limb::tree::floats;
    constexpr int size = Limb::tree::base + static_cast<int>(Limb::n);
    const auto joints = cca::detail::placed_joints<S>(Limb::body, values);
    limb_dynamics found;
    found.frames = frames_of(joints);
    cca::detail::link_motion<S> root;
    root.w = turning, root.a = up;
    found.at_base.load =
        cca::detail::add_newton_euler(Limb::body, joints, root, speeds, std::array<S, Limb::n>{}, found.bias);
    cca::detail::square<S, size> m;
    cca::detail::add_mass_matrix<floats>(Limb::body, joints, m);
    for (std::size_t k = 0; k < Limb::entries; ++k)
      found.entries[k] = m(Limb::places[k].row, Limb::places[k].column);
    if constexpr (floats) {
      std::size_t k = 0;
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c <= r; ++c) found.at_base.turning[k++] = m(r, c);
      found.at_base.first = {m(2, 4), m(0, 5), m(1, 3)};
    }
    return found;
  }
  template <class Joints>
  static constexpr auto frames_of(const Joints& joints) {
    std::array<bool, Limb::links> all{};
    for (bool& is_wanted : all) is_wanted = true;
    return cca::detail::placed_frames(Limb::body, joints, all);
  }

  // All its numbers, in one order: first those that lie in M and with the links.
  static constexpr std::size_t count =
      12 * Limb::links + Limb::n + Limb::entries + (Limb::tree::floats ? std::size_t{15} : 0);
  template <class F>
  constexpr void each(F f) const {
    for (const auto& frame : frames) {
      for (const auto& axis : frame.axes)
        for (const S& x : axis.e) f(x);
      for (const S& x : frame.at.e) f(x);
    }
    for (const S& x : bias) f(x);
    for (const S& x : entries) f(x);
    if constexpr (Limb::tree::floats) {
      for (const S& x : at_base.load.moment.e) f(x);
      for (const S& x : at_base.load.force.e) f(x);
      for (const S& x : at_base.turning) f(x);
      for (const S& x : at_base.first.e) f(x);
    }
  }
};

// The recording. NaN may vanish in it: whoever uses it looks at the motion after the step.
template <class Limb>
struct recorded_limb {
  static constexpr bool is_small = Limb::links > 0 && Limb::links <= 16;
  static constexpr auto values = static_cast<int>(Limb::values), n = static_cast<int>(Limb::n);
  static constexpr std::array sizes{2 * values, n, 3, 3};
  static constexpr int group(int) { return 0; }
  static constexpr int owner(int) { return 0; }
  static constexpr bool may_vanish(int) { return false; }

  static constexpr void record(cca::detail::recorder& r) {
    using cca::detail::recorded;
    r.keeps_signs = true;
    int next = 0;
    const auto read = [&](auto& all) {
      for (recorded& x : all) x = r.input(next++);
    };
    std::array<recorded, static_cast<std::size_t>(2 * values)> joints;
    std::array<recorded, Limb::n> speeds;
    triple<recorded> turning, up;
    read(joints), read(speeds), read(turning.e), read(up.e);
    limb_dynamics<Limb, recorded>::of(joints, speeds, turning, up).each([&](const recorded& x) {
      r.output(x);
    });
  }
};

}  // namespace cca::sim::detail
