// For programs: a virtual moteus. The code is in `virtual_drives/`.
#pragma once

#include <cca/hardware/virtual_drives/virtual_moteus.hpp>
