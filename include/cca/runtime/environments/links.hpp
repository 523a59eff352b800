// Moved: runtime/environments/links/links.hpp.
#pragma once

#include <cca/runtime/environments/links/links.hpp>
