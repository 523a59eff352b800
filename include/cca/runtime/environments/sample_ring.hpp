// Moved: runtime/environments/exchange/sample_ring.hpp.
#pragma once

#include <cca/runtime/environments/exchange/sample_ring.hpp>
