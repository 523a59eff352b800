// For programs: a virtual drive of the MIT protocol. The code is in `virtual_drives/`.
#pragma once

#include <cca/hardware/virtual_drives/virtual_mit.hpp>
