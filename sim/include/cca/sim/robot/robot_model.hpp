// A former path of robot/model/robot_model.hpp: a described robot as numbers.
#pragma once

#include <cca/sim/robot/model/robot_model.hpp>
