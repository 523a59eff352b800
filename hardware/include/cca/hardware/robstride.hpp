// For programs: RobStride drives. The code is in `drives/`.
#pragma once

#include <cca/hardware/drives/robstride.hpp>
