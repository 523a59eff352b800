// Moved: runtime/environments/exchange/peers.hpp.
#pragma once

#include <cca/runtime/environments/exchange/peers.hpp>
