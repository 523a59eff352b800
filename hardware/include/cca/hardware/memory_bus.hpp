// For programs: a CAN bus in memory. The code is in `bus/`.
#pragma once

#include <cca/hardware/bus/memory_bus.hpp>
