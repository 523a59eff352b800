// For programs: what all virtual drives have in common. The code is in `virtual_drives/`.
#pragma once

#include <cca/hardware/virtual_drives/virtual_drive.hpp>
