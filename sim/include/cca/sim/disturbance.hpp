// A former path of oncilla/disturbance.hpp: pushes at the Oncilla.
#pragma once

#include <cca/sim/oncilla/disturbance.hpp>
