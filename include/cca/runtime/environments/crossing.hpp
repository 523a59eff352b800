// Moved: runtime/environments/exchange/crossing.hpp.
#pragma once

#include <cca/runtime/environments/exchange/crossing.hpp>
