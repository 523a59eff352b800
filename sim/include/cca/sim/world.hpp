// A former path of oncilla/world.hpp: the world of the Oncilla.
#pragma once

#include <cca/sim/oncilla/world.hpp>
