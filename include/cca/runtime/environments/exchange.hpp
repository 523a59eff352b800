// Moved: runtime/environments/exchange/exchange.hpp.
#pragma once

#include <cca/runtime/environments/exchange/exchange.hpp>
