#pragma once
// The demonstrator with the arm on drives: one type is another than in the simulator.
#include <utility>

#include <cca/hardware/virtual_hardware.hpp>
#include <cca/sim/robot/plant.hpp>

#include "architecture.hpp"
#include "drives.hpp"
#include "rollout.hpp"

namespace touch {

// [on drives]
struct with_canopen : architecture<on_canopen::robot<hw::virtual_bus_end>> {};
struct with_moteus : architecture<on_moteus::robot<hw::virtual_bus_end>> {};
// [on drives end]

// Where the arm is: the simulator moves it, after virtual drives on buses in memory. It has brakes. `World`:
// what it is simulated in, as of cca::sim::robot.
template <class Robot, class World = cca::sim::robot_world>
struct on_virtual_drives {
  using plant = cca::sim::plant<arm::description, World>;
  using arm_world = typename plant::world_type;

  template <class Controller>
  explicit on_virtual_drives(Controller& c) : far(c.template get<"robot.synchronizer">()) {
    far.plant.hold = cca::sim::held_by::brakes;
  }
  template <class Controller>
  void put_down(Controller&, arm_world&& world) {
    far.plant.put_down(std::move(world));
  }
  template <class Controller>
  arm_world& world(Controller&) {
    return far.plant.world();
  }
  template <class Controller>
  void after_beat(Controller&) {
    far.step();
  }

  hw::virtual_hardware<Robot, plant> far;
};
using behind_canopen = on_virtual_drives<on_canopen::robot<hw::virtual_bus_end>>;
using behind_moteus = on_virtual_drives<on_moteus::robot<hw::virtual_bus_end>>;

}  // namespace touch
