// The contacts of the feet in one physics step: what they carry, how fast they slip, and the work that
// friction takes.
//
// `add` each contact before the engine's step, `account` for all after it. The engine computes a step's
// forces for the speeds at its end, so friction work is force times that speed. A contact's speed is that of
// the foot's material point, along the ground.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <ode/ode.h>

#include <cca/sim/attitude.hpp>
#include <cca/sim/oncilla_model.hpp>
#include <cca/sim/state.hpp>

namespace cca::sim {

class footing {
public:
  footing() = default;
  footing(const footing&) = delete;  // the engine writes into it
  footing& operator=(const footing&) = delete;

  void add(std::size_t leg, dJointID joint, dBodyID foot, const dContactGeom& place) {
    if (count_ == most) return;
    contact& c = contacts_[count_++];
    const dReal* centre = dBodyGetPosition(foot);
    c = {leg, foot, {}, {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      c.normal[k] = place.normal[k];
      c.arm[k] = place.pos[k] - centre[k];
    }
    dJointSetFeedback(joint, &c.feedback);
  }

  void account(world_state& state, const oncilla_model& m) const {
    for (foot_account& foot : state.feet) foot.pressing = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const contact& c = contacts_[i];
      foot_account& foot = state.feet[c.leg];
      const vector3 force{c.feedback.f1[0], c.feedback.f1[1], c.feedback.f1[2]};
      for (std::size_t k = 0; k < 3; ++k)
        state.reading.legs[c.leg].foot_force[k] += force[k] / m.steps_per_beat;

      const double load = std::max(0.0, dot(force, c.normal));
      const vector3 slip = along_ground(c, speed(c));
      foot.pressing += load;
      foot.load += load * m.step;
      foot.slip += load * std::sqrt(dot(slip, slip)) * m.step;
      foot.friction_work -= dot(force, slip) * m.step;
    }
  }

private:
  struct contact {
    std::size_t leg;
    dBodyID foot;
    vector3 normal, arm;  // out of the ground; from the foot's centre of mass to the contact
    dJointFeedback feedback;
  };

  static double dot(const vector3& a, const vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  static vector3 speed(const contact& c) {
    const dReal* v = dBodyGetLinearVel(c.foot);
    const dReal* w = dBodyGetAngularVel(c.foot);
    return {v[0] + w[1] * c.arm[2] - w[2] * c.arm[1], v[1] + w[2] * c.arm[0] - w[0] * c.arm[2],
            v[2] + w[0] * c.arm[1] - w[1] * c.arm[0]};
  }

  static vector3 along_ground(const contact& c, vector3 v) {
    const double into = dot(v, c.normal);
    for (std::size_t k = 0; k < 3; ++k) v[k] -= into * c.normal[k];
    return v;
  }

  static constexpr std::size_t most = 32;
  std::size_t count_ = 0;
  std::array<contact, most> contacts_;
};

}  // namespace cca::sim
