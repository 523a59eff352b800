// For programs: ODrive axes. The code is in `drives/`.
#pragma once

#include <cca/hardware/drives/odrive.hpp>
