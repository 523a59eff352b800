// A former path of engine/ground_strips.hpp: a terrain in the engine.
#pragma once

#include <cca/sim/engine/ground_strips.hpp>
