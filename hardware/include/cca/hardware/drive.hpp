// For programs: what all drives have in common. The code is in `drives/`.
#pragma once

#include <cca/hardware/drives/drive.hpp>
