// A closed set of architectures for one robot, of which one is active: `mode`, `modes`, and their controller.
#pragma once

#include <cca/graph/describe_modes.hpp>
#include <cca/graph/items/modes.hpp>
#include <cca/runtime/modes/mode_controller.hpp>
