// For programs: the board with inertial unit and foot sensors. The code is in `robot/`.
#pragma once

#include <cca/hardware/oncilla/sensor_board.hpp>
