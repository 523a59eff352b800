// Moved: adaptive/choice/preference.hpp.
#pragma once

#include <cca/adaptive/choice/preference.hpp>
