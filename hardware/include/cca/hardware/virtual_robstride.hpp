// For programs: a virtual RobStride. The code is in `virtual_drives/`.
#pragma once

#include <cca/hardware/virtual_drives/virtual_robstride.hpp>
