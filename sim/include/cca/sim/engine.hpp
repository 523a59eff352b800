// The owner of one world of the Open Dynamics Engine: initialises the library and its data of this thread,
// makes the world and its threading.
//
// Each world has its own self-threaded implementation: with the shared default, two worlds that are stepped
// in two threads abort in `ReleaseAJob`. The memory of a step is reserved in advance, so a beat with more
// contacts than any before does not allocate.
#pragma once

#include <memory>
#include <stdexcept>

#include <ode/ode.h>

#include <cca/sim/robot/engine_settings.hpp>

namespace cca::sim {

// Initialises the library once per process, and its data once per thread.
inline void prepare_engine() {
  static const bool library = dInitODE2(0) != 0;
  thread_local const bool data =
      library && dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll)) != 0;
  if (!data) throw std::runtime_error("the Open Dynamics Engine cannot be initialised");
}

struct engine_release {
  void operator()(dxThreadingImplementation* t) const { dThreadingFreeImplementation(t); }
  void operator()(dxWorld* w) const { dWorldDestroy(w); }
  void operator()(dxJointGroup* g) const { dJointGroupDestroy(g); }
  void operator()(dxGeom* g) const { dGeomDestroy(g); }
};

template <class T>
using engine_handle = std::unique_ptr<T, engine_release>;

class engine {
public:
  explicit engine(const engine_settings& m) {
    prepare_engine();
    threading_.reset(dThreadingAllocateSelfThreadedImplementation());
    world_.reset(dWorldCreate());
    contacts_.reset(dJointGroupCreate(0));
    dWorldSetStepThreadingImplementation(id(), dThreadingImplementationGetFunctions(threading_.get()),
                                         threading_.get());
    const dWorldStepReserveInfo reserve{sizeof(dWorldStepReserveInfo), 1.2F, step_memory};
    dWorldSetStepMemoryReservationPolicy(id(), &reserve);
    dWorldSetGravity(id(), 0, 0, -m.gravity);
    dWorldSetERP(id(), m.erp);
    dWorldSetCFM(id(), m.cfm);
    dWorldSetAutoDisableFlag(id(), 0);
    dWorldSetContactMaxCorrectingVel(id(), m.correcting_speed);
    dWorldSetContactSurfaceLayer(id(), m.surface_layer);
  }

  dWorldID id() const { return world_.get(); }
  dJointGroupID contacts() const { return contacts_.get(); }

  void step(double dt) { dWorldStep(id(), dt); }

private:
  static constexpr unsigned step_memory = 1U << 20;

  engine_handle<dxThreadingImplementation> threading_;  // must outlive the world
  engine_handle<dxWorld> world_;
  engine_handle<dxJointGroup> contacts_;  // is destroyed before the world
};

}  // namespace cca::sim
