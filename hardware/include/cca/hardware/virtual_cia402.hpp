// For programs: a virtual CANopen drive. The code is in `virtual_drives/`.
#pragma once

#include <cca/hardware/virtual_drives/virtual_cia402.hpp>
