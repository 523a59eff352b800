// For programs: drives of the MIT mini-cheetah protocol. The code is in `drives/`.
#pragma once

#include <cca/hardware/drives/mit.hpp>
