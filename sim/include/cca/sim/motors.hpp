// A shorter or former path of robot/cable_winch.hpp: a motor that winds a cable.
#pragma once

#include <cca/sim/robot/cable_winch.hpp>
