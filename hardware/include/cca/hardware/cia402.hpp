// For programs: CANopen drives. The code is in `drives/`.
#pragma once

#include <cca/hardware/drives/cia402.hpp>
