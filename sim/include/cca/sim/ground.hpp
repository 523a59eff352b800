// A shorter or former path of robot/ground_strips.hpp: a terrain in the engine.
#pragma once

#include <cca/sim/robot/ground_strips.hpp>
