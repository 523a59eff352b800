// A board with force sensors alone: robot_board.hpp has its protocol.
//
//   using flange_board = cca::hardware::load_board<0x40, 1, 3>;   // one sensor, on bus 3
#pragma once

#include <cca/hardware/robot/boards/robot_board.hpp>

namespace cca::hardware {

template <std::size_t Sensors>
using load_reading = robot_board_reading<Sensors, 0>;

template <std::uint32_t Base, std::size_t Sensors, std::size_t Bus = 0, bit_rates Rates = bit_rates{}>
using load_board = robot_board<Base, Sensors, 0, Bus, Rates>;

}  // namespace cca::hardware
