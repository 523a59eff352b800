// A former path of engine/engine_alarm.hpp: what the engine says of itself.
#pragma once

#include <cca/sim/engine/engine_alarm.hpp>
