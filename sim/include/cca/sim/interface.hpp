// A former path of oncilla/oncilla_posture.hpp: postures, commands and readings of an Oncilla, by leg.
#pragma once

#include <cca/sim/oncilla/oncilla_posture.hpp>
