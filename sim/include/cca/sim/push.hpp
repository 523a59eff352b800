// A former path of robot/model/push.hpp: a push.
#pragma once

#include <cca/sim/robot/model/push.hpp>
