// Short path: a robot's drives, board and mechanics in memory.
#pragma once

#include <cca/hardware/virtual_drives/virtual_hardware.hpp>
