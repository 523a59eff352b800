// For programs: a CAN bus by Linux SocketCAN. The code is in `bus/`.
#pragma once

#include <cca/hardware/bus/socket_can.hpp>
