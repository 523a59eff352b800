// Sets of modes: somebody switches them between two beats, and so do their components.
#pragma once

#include <cca/modes.hpp>

#include "run.hpp"
