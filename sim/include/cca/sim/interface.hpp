// A shorter or former path of oncilla_posture.hpp: postures, commands and readings of an Oncilla, by leg.
#pragma once

#include <cca/sim/oncilla_posture.hpp>
