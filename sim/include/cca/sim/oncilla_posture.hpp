// A former path of oncilla/oncilla_posture.hpp: postures of the Oncilla.
#pragma once

#include <cca/sim/oncilla/oncilla_posture.hpp>
