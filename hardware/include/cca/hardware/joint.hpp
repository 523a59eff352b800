// For programs: a drive mounted as a joint of a robot. The code is in `drives/`.
#pragma once

#include <cca/hardware/drives/joint.hpp>
