// The momentum of a reduced body's coordinates and how motion alone changes it, for recordings: in the axes
// of the links. Formulas and sources: dynamics/momentum.hpp.
#pragma once

#include <cca/robot/recorded/torque_derivatives.hpp>

namespace cca::detail {

// Velocities. Gives the momentum, then its change.
template <class Body>
struct recorded_joint_momentum : recorded_quantity<Body, 1, 0> {
  using q = recorded_quantity<Body, 1, 0>;
  static constexpr std::array results{q::n, q::n};
  static constexpr void record(recorder& r) {
    constexpr auto count = static_cast<std::size_t>(q::links);
    typename q::reader in{r};
    const auto dq = in.coordinates();
    const auto joints = in.joints();
    std::array<link_motion<recorded>, count> motion;
    std::array<triple<recorded>, count> velocity;
    std::array<link_load<recorded>, count> momenta;
    for (std::size_t i = 0; i < count; ++i) {
      const reduced_link& l = q::body.links[i];
      const auto p = static_cast<std::size_t>(l.parent);
      const link_motion<recorded> before = l.parent < 0 ? link_motion<recorded>{} : motion[p];
      const recorded speed = recorded(l.ratio) * dq[static_cast<std::size_t>(l.coordinate)];
      velocity[i] =
          velocity_behind(joints[i], before.w, l.parent < 0 ? triple<recorded>{} : velocity[p], speed);
      motion[i] = motion_behind(joints[i], before, speed, recorded());
      momenta[i] = load_of(composite<recorded>(l.mass), {motion[i].w, velocity[i]});
    }
    typename q::vector momentum{}, change{};
    for (std::size_t i = count; i-- > 0;) {
      const reduced_link& l = q::body.links[i];
      const auto c = static_cast<std::size_t>(l.coordinate);
      const joint_field<recorded> field(l, motion[i], velocity[i]);
      const link_load<recorded>& h = momenta[i];
      momentum[c] = momentum[c] + recorded(l.ratio) * (l.revolute ? h.moment[l.axis] : h.force[l.axis]);
      change[c] = change[c] + product(h, field.first);
      if (l.parent < 0) continue;
      const triple<recorded> force = joints[i].up(h.force);
      momenta[static_cast<std::size_t>(l.parent)] =
          momenta[static_cast<std::size_t>(l.parent)] +
          link_load<recorded>{joints[i].up(h.moment) + cross(joints[i].at, force), force};
    }
    q::write(r, momentum, q::sets.branches);
    q::write(r, change, q::sets.branches);
  }
};

}  // namespace cca::detail
