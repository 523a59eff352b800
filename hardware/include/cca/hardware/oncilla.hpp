// For programs: the Oncilla on real drives. The code is in `robot/`.
#pragma once

#include <cca/hardware/robot/oncilla.hpp>
