// Moved: runtime/environments/loop/environment_loop.hpp.
#pragma once

#include <cca/runtime/environments/loop/environment_loop.hpp>
