// Moved: runtime/environments/exchange/histogram.hpp.
#pragma once

#include <cca/runtime/environments/exchange/histogram.hpp>
