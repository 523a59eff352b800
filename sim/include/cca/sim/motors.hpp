// A former path of robot/model/cable_winch.hpp: a motor that winds a cable.
#pragma once

#include <cca/sim/robot/model/cable_winch.hpp>
