// For programs: moteus drives. The code is in `drives/`.
#pragma once

#include <cca/hardware/drives/moteus.hpp>
