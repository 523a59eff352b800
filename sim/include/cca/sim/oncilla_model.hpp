// A former path of oncilla/oncilla_model.hpp: the numbers of the Oncilla.
#pragma once

#include <cca/sim/oncilla/oncilla_model.hpp>
