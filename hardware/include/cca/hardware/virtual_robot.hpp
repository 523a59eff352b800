// For programs: the far end of a robot's buses. The code is in `virtual_drives/`.
#pragma once

#include <cca/hardware/virtual_drives/virtual_robot.hpp>
