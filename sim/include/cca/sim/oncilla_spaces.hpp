// The axes and spaces of the simulated Oncilla: those of any Oncilla, under the names cca::sim::leg_angles
// and so on. They are defined in cca/robots/oncilla/spaces.hpp.
#pragma once

#include <cca/robots/oncilla/former_names.hpp>
