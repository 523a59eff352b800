#pragma once
// The terrain in the engine, and the robot's parts that can touch it.
//
// Each part is tested against every strip of ground in a fixed order, without a space or broad phase of the
// engine: their order would depend on addresses, and the same run would give other bits. Parts don't collide
// with each other. Contacts are springs and dampers, given to the engine as ERP and CFM. Friction is a
// pyramid in proportion to the normal force (dContactApprox1; without it `mu` would be a force in newtons).
#include <array>
#include <cmath>
#include <vector>

#include <ode/ode.h>

#include <cca/sim/attitude.hpp>
#include <cca/sim/engine.hpp>
#include <cca/sim/oncilla_model.hpp>
#include <cca/sim/terrain.hpp>

namespace cca::sim {

class ground {
public:
  ground(const oncilla_model& m, const terrain& shape) {
    for (const ground_strip& s : shape.strips()) strips_.push_back(box(s));
    prototype_.mode = dContactSoftERP | dContactSoftCFM | dContactApprox1;
    prototype_.mu = shape.friction();
    const double stiff = m.step * m.contact_stiffness;
    prototype_.soft_erp = stiff / (stiff + m.contact_damping);
    prototype_.soft_cfm = 1 / (stiff + m.contact_damping);
  }

  // Makes the contacts of a part for this physics step, and calls `on_contact(joint)` for each of them.
  template <class OnContact>
  void touch(const engine& e, dGeomID part, OnContact on_contact) const {
    std::array<dContact, 4> contacts;
    for (const auto& strip : strips_) {
      const int count =
          dCollide(part, strip.get(), static_cast<int>(contacts.size()), &contacts[0].geom, sizeof(dContact));
      for (int i = 0; i < count; ++i) {
        dContact& c = contacts[static_cast<std::size_t>(i)];
        c.surface = prototype_;
        const dJointID joint = dJointCreateContact(e.id(), e.contacts(), &c);
        dJointAttach(joint, dGeomGetBody(part), nullptr);
        on_contact(joint);
      }
    }
  }

private:
  static constexpr double depth = 1.0, width = 100.0;

  // A box whose top begins at the strip's edge. Where it overlaps a neighbour it lies below the neighbour's
  // top.
  static engine_handle<dxGeom> box(const ground_strip& s) {
    engine_handle<dxGeom> geom(dCreateBox(nullptr, s.length, width, depth));
    const double c = std::cos(s.pitch), n = std::sin(s.pitch);
    const double along = s.length / 2, down = depth / 2;
    dGeomSetPosition(geom.get(), s.from_x + along * c + down * n, 0, s.from_z + along * n - down * c);
    dMatrix3 rotation;
    dRFromAxisAndAngle(rotation, 0, -1, 0, s.pitch);
    dGeomSetRotation(geom.get(), rotation);
    return geom;
  }

  std::vector<engine_handle<dxGeom>> strips_;
  dSurfaceParameters prototype_{};
};

// A shape on a body, outside of any space of the engine.
inline engine_handle<dxGeom> sphere_on(dBodyID body, double radius, vector3 offset = {}) {
  engine_handle<dxGeom> geom(dCreateSphere(nullptr, radius));
  dGeomSetBody(geom.get(), body);
  if (offset != vector3{}) dGeomSetOffsetPosition(geom.get(), offset[0], offset[1], offset[2]);
  return geom;
}

inline engine_handle<dxGeom> box_on(dBodyID body, double length, double width, double height) {
  engine_handle<dxGeom> geom(dCreateBox(nullptr, length, width, height));
  dGeomSetBody(geom.get(), body);
  return geom;
}

}  // namespace cca::sim
