// For programs: which drives are on a bus, checked while compiling. The code is in `drives/`.
#pragma once

#include <cca/hardware/drives/bus_plan.hpp>
