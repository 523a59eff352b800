// A former path of engine/scene.hpp: what stands around a robot.
#pragma once

#include <cca/sim/engine/scene.hpp>
