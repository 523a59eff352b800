// A former path of engine/terrain.hpp: the ground.
#pragma once

#include <cca/sim/engine/terrain.hpp>
