// A former path of engine/engine.hpp: the engine.
#pragma once

#include <cca/sim/engine/engine.hpp>
