// For programs: the end of a robot in order. The code is in `robot/`.
#pragma once

#include <cca/hardware/robot/shut_down.hpp>
