// The terrain in the engine, and the robot's parts that can touch it.
//
// Each part is tested against the strips of ground below it from left to right, without a space or broad
// phase of the engine: their order would depend on addresses, and the same run would give other bits. Parts
// don't collide with each other. Contacts are springs and dampers, given to the engine as ERP and CFM, so
// they don't depend on the step.
//
// Friction is a pyramid: along each of two axes at most `mu` times the load. The engine can compute that
// limit itself (dContactApprox1), but it takes the load that there would be without friction. On a light toe
// that load is wrong by an amount that grows with step times damping, and the trot's speed followed the step.
// So a foot's limit comes from its load in the step before, as a force in newtons. Knees, ankles and the
// trunk, which touch the ground only in a fall or at an edge, use the engine's.
#pragma once

#include <array>

#include <ode/ode.h>

#include <cca/sim/attitude.hpp>
#include <cca/sim/engine.hpp>
#include <cca/sim/oncilla_model.hpp>
#include <cca/sim/robot/ground_strips.hpp>
#include <cca/sim/terrain.hpp>

namespace cca::sim {

class ground {
public:
  ground(const oncilla_model& m, const terrain& shape) : strips_(shape) {
    prototype_.mode = dContactSoftERP | dContactSoftCFM | dContactApprox1;
    prototype_.mu = shape.friction();
    const double stiff = m.step * m.contact_stiffness;
    prototype_.soft_erp = stiff / (stiff + m.contact_damping);
    prototype_.soft_cfm = 1 / (stiff + m.contact_damping);
  }

  // Makes the contacts of a part for this physics step, and calls `on_contact(joint, place)` for each of
  // them.
  template <class OnContact>
  void touch(const engine& e, dGeomID part, OnContact on_contact) const {
    touch(e, part, prototype_, on_contact);
  }

  // The same for a part whose load is known, in newtons.
  template <class OnContact>
  void touch(const engine& e, dGeomID part, double load, OnContact on_contact) const {
    dSurfaceParameters surface = prototype_;
    surface.mode &= ~dContactApprox1;
    surface.mu *= load;
    touch(e, part, surface, on_contact);
  }

private:
  template <class OnContact>
  void touch(const engine& e, dGeomID part, const dSurfaceParameters& surface, OnContact& on_contact) const {
    strips_.each_under(part, [&](dGeomID box) {
      std::array<dContact, 4> contacts;
      const int count =
          dCollide(part, box, static_cast<int>(contacts.size()), &contacts[0].geom, sizeof(dContact));
      for (int i = 0; i < count; ++i) {
        dContact& c = contacts[static_cast<std::size_t>(i)];
        c.surface = surface;
        const dJointID joint = dJointCreateContact(e.id(), e.contacts(), &c);
        dJointAttach(joint, dGeomGetBody(part), nullptr);
        on_contact(joint, c.geom);
      }
    });
  }

  ground_strips strips_;
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
