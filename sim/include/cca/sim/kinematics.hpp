// A former path of oncilla/kinematics.hpp: the legs of the Oncilla.
#pragma once

#include <cca/sim/oncilla/kinematics.hpp>
