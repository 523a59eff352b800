// The owner of one world of the Open Dynamics Engine: initialises the library and its data of this thread,
// makes the world and its threading.
//
// Each world has its own self-threaded implementation: with the shared default, two worlds that are stepped
// in two threads abort in `ReleaseAJob`. The memory of a step is reserved in advance, so a beat with more
// contacts than any before does not allocate. All that a beat asks of the engine runs within `guarded`: it
// returns false when the engine itself gives up (engine_alarm.hpp), and ever after.
#pragma once

#include <memory>
#include <stdexcept>

#include <ode/ode.h>

#include <cca/sim/engine/engine_alarm.hpp>
#include <cca/sim/engine/engine_settings.hpp>

namespace cca::sim {

// Initialises the library once per process, and its data once per thread.
inline void prepare_engine() {
  static const bool library = dInitODE2(0) != 0 && (listen_to_engine(), true);
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
    parts_.reset(new parts);
    parts_->threading.reset(dThreadingAllocateSelfThreadedImplementation());
    parts_->world.reset(dWorldCreate());
    parts_->contacts.reset(dJointGroupCreate(0));
    dWorldSetStepThreadingImplementation(id(), dThreadingImplementationGetFunctions(parts_->threading.get()),
                                         parts_->threading.get());
    const dWorldStepReserveInfo reserve{sizeof(dWorldStepReserveInfo), 1.2F, step_memory};
    dWorldSetStepMemoryReservationPolicy(id(), &reserve);
    dWorldSetGravity(id(), 0, 0, -m.gravity);
    dWorldSetERP(id(), m.erp);
    dWorldSetCFM(id(), m.cfm);
    dWorldSetAutoDisableFlag(id(), 0);
    dWorldSetContactMaxCorrectingVel(id(), m.correcting_speed);
    dWorldSetContactSurfaceLayer(id(), m.surface_layer);
  }

  dWorldID id() const { return parts_->world.get(); }
  dJointGroupID contacts() const { return parts_->contacts.get(); }

  template <class F>
  bool guarded(F f) {
    if (parts_->has_failed) return false;
    const engine_alarms_thrown here;
    try {
      f();
    } catch (const engine_alarm&) { parts_->has_failed = true; }
    return !parts_->has_failed;
  }
  bool step(double dt) {
    return guarded([&] { dWorldStep(id(), dt); });
  }

private:
  static constexpr unsigned step_memory = 1U << 20;

  struct parts {
    engine_handle<dxThreadingImplementation> threading;  // must outlive the world
    engine_handle<dxWorld> world;
    engine_handle<dxJointGroup> contacts;  // is destroyed before the world
    bool has_failed = false;
  };
  // A world that gave up within a step has jobs that never end; to destroy it would be an error.
  struct release_unless_failed {
    void operator()(parts* p) const {
      if (!p->has_failed) delete p;
    }
  };

  std::unique_ptr<parts, release_unless_failed> parts_;
};

}  // namespace cca::sim
