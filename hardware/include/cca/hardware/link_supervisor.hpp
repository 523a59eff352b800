// For programs: whether set points may go out on a bus. The code is in `safety/`.
#pragma once

#include <cca/hardware/safety/link_supervisor.hpp>
