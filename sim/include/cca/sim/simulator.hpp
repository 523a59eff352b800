// A former path of oncilla/simulator.hpp: the simulated Oncilla.
#pragma once

#include <cca/sim/oncilla/simulator.hpp>
