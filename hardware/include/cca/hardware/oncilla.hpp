// For programs: the Oncilla on real drives, and its end in order. The code is in `robot/`.
#pragma once

#include <cca/hardware/oncilla/oncilla.hpp>
#include <cca/hardware/robot/shut_down.hpp>
