// The contacts of a robot, of balls and of what stands around them, in one physics step.
//
// Each pair of shapes is tested in a fixed order, without a space or broad phase of the engine: their order
// would depend on addresses, and the same run would give other bits. Shapes of one robot touch each other if
// its description says so, and what doesn't move is not tested against what doesn't move. Contacts are
// springs and dampers, given to the engine as ERP and CFM, so they don't depend on the step. Friction is a
// pyramid: along each of two axes at most `friction` times the load that the pair had in the step before,
// shared by its contacts (docs/simulator.md says why not the engine's own). So there is none in the first
// step of a contact.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <ode/ode.h>

#include <cca/base/math/reductions.hpp>
#include <cca/base/eigen.hpp>
#include <cca/robot/dynamics/spatial_inertia.hpp>
#include <cca/sim/engine/engine.hpp>
#include <cca/sim/engine/ground_strips.hpp>
#include <cca/sim/engine/scene.hpp>

namespace cca::sim {

// A force of the world on a robot's shape, in the world.
struct touch {
  std::size_t shape = 0;  // of the robot
  Eigen::Vector3d at, force;
  Eigen::Vector3d normal;  // of the surface, into the shape
  Eigen::Vector3d slip;    // the speed of the shape along the surface, m/s
  int second_shape = -1;   // of the robot, which it touches itself with: the opposite force acts on it
};

class touching {
public:
  touching(const contact_numbers& numbers, double step) : friction_(numbers.friction) {
    surface_.mode = dContactSoftERP | dContactSoftCFM;
    const double stiff = step * numbers.stiffness;
    surface_.soft_erp = stiff / (stiff + numbers.damping);
    surface_.soft_cfm = 1 / (stiff + numbers.damping);
  }

  // `first` moves. The load of each pair is kept in `load_of`, whose size is the number of pairs. Pairs whose
  // first shape is the robot's come first.
  struct pair {
    dGeomID first, second;
    int shape = -1;                         // of the robot
    const ground_strips* ground = nullptr;  // then there is no second shape
    int second_shape = -1;                  // of the robot
  };
  void set_pairs(std::vector<pair> pairs) {
    pairs_ = std::move(pairs);
    contacts_.reserve(most * pairs_.size());
  }
  std::size_t pair_count() const { return pairs_.size(); }

  // Makes the contacts of this step; the engine writes their forces when it steps.
  void find(const engine& e, const std::vector<double>& load_of) {
    contacts_.clear();
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const pair& p = pairs_[i];
      std::array<dContact, most> found;
      const int count = meet(p, found);
      for (int k = 0; k < count; ++k) {
        dContact& c = found[static_cast<std::size_t>(k)];
        c.surface = surface_;
        c.surface.mu = (p.ground ? p.ground->friction() : friction_) * load_of[i] / count;
        const dJointID joint = dJointCreateContact(e.id(), e.contacts(), &c);
        dJointAttach(joint, dGeomGetBody(p.first), p.ground ? nullptr : dGeomGetBody(p.second));
        contact& kept = contacts_.emplace_back();
        kept.pair = i;
        for (int n = 0; n < 3; ++n) kept.at[n] = c.geom.pos[n], kept.normal[n] = c.geom.normal[n];
        dJointSetFeedback(joint, &kept.feedback);
      }
    }
  }

  // After the engine's step: the load of each pair, and each contact of the robot.
  template <class OnTouch>
  void account(std::vector<double>& load_of, OnTouch on_touch) {
    std::fill(load_of.begin(), load_of.end(), 0.0);
    for (const contact& c : contacts_) {
      const Eigen::Vector3d force = Eigen::Vector3d::Map(c.feedback.f1);
      load_of[c.pair] += std::max(0.0, math::dot(force, c.normal));
      if (const int shape = pairs_[c.pair].shape; shape >= 0)
        on_touch(touch{static_cast<std::size_t>(shape), c.at, force, c.normal, slip_of(c),
                       pairs_[c.pair].second_shape});
    }
    contacts_.clear();
  }

private:
  static constexpr int most = 8;  // contacts of a pair

  struct contact {
    std::size_t pair;
    Eigen::Vector3d at, normal;  // the normal points into the first shape
    dJointFeedback feedback;
  };

  Eigen::Vector3d slip_of(const contact& c) const {
    const pair& p = pairs_[c.pair];
    const Eigen::Vector3d speed =
        speed_of(dGeomGetBody(p.first), c.at) - speed_of(p.second ? dGeomGetBody(p.second) : nullptr, c.at);
    return speed - math::dot(speed, c.normal) * c.normal;
  }
  // Of the material point of a body; null: it stands.
  static Eigen::Vector3d speed_of(dBodyID b, const Eigen::Vector3d& at) {
    if (!b) return Eigen::Vector3d::Zero();
    const Eigen::Vector3d arm = at - Eigen::Vector3d::Map(dBodyGetPosition(b)),
                          w = Eigen::Vector3d::Map(dBodyGetAngularVel(b));
    return Eigen::Vector3d::Map(dBodyGetLinearVel(b)) + cca::detail::cross(w, arm);
  }

  static int meet(const pair& p, std::array<dContact, most>& found) {
    int count = 0;
    const auto collide = [&](dGeomID other) {
      if (count < most)
        count += dCollide(p.first, other, most - count, &found[static_cast<std::size_t>(count)].geom,
                          sizeof(dContact));
    };
    if (p.ground) p.ground->each_under(p.first, collide);
    else if (boxes_meet(p.first, p.second)) collide(p.second);
    return count;
  }

  static bool boxes_meet(dGeomID a, dGeomID b) {
    std::array<dReal, 6> x, y;
    dGeomGetAABB(a, x.data());
    dGeomGetAABB(b, y.data());
    for (std::size_t k = 0; k < 6; k += 2)
      if (x[k] > y[k + 1] || y[k] > x[k + 1]) return false;
    return true;
  }

  double friction_;
  dSurfaceParameters surface_{};
  std::vector<pair> pairs_;
  std::vector<contact> contacts_;
};

}  // namespace cca::sim
