// A former path of oncilla/attitude.hpp: roll, pitch and yaw.
#pragma once

#include <cca/sim/oncilla/attitude.hpp>
