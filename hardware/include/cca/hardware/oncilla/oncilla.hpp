// The Oncilla on real drives as a graph with the ports of the simulated one:
// `cca::node<"robot", my_oncilla>`, where
//
//   struct my_oncilla : cca::hardware::oncilla<cca::hardware::socket_can, left_front_hip_drive, ..., board>
//   {};
//
// It is hardware::robot of robots/oncilla/as_built.hpp, which has the ports. Bus: any CanBus. Drives: eight
// joints (joint.hpp) or a joint_list, those of robots::oncilla::leg_axes, then the sensor board
// (sensor_board.hpp), whose servos move the abductions. The limits of the axes bound it;
// robots/oncilla/body.hpp says which of them are chosen.
//
// Errors: those of robot.hpp. Example: examples/hardware_in_the_loop; docs/hardware.md.
#pragma once

#include <cca/hardware/oncilla/sensor_board.hpp>
#include <cca/hardware/robot/robot.hpp>
#include <cca/robots/oncilla/as_built.hpp>
#include <cca/robots/oncilla/former_names.hpp>

namespace cca::hardware {

template <class Bus, class... Drives>
struct oncilla : detail::unchecked_robot<robots::oncilla::as_built, Bus, Drives...> {
  static_assert(detail::robot_check<robots::oncilla::as_built, Bus, Drives...>::value);
};

}  // namespace cca::hardware
