// The twin of examples/hardware_in_the_loop, in one process or on CAN interfaces: what its drives report
// comes from the robot, so this one has buses that are connected to nothing.
#include <cca/cca.hpp>
#include <cca/hardware/virtual_hardware.hpp>

#include "beside_buses.hpp"

#include "twin.hpp"

namespace {

struct twin_on_drives : hil::trot_beside_buses<cca::hardware::virtual_bus_end>, cca::recordable {};

}  // namespace

cca::page::twin_program& cca::page::twin() {
  static twin_of<twin_on_drives> robot;
  return robot;
}
