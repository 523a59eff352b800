// For programs: frames, filters and what every bus can do. The code is in `bus/`.
#pragma once

#include <cca/hardware/bus/can_bus.hpp>
