// For programs: a virtual ODrive. The code is in `virtual_drives/`.
#pragma once

#include <cca/hardware/virtual_drives/virtual_odrive.hpp>
