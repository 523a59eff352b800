// For programs: positions of drives that wrap. The code is in `drives/`.
#pragma once

#include <cca/hardware/drives/position_unwrap.hpp>
