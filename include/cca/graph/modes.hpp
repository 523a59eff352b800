// A shorter path of items/modes.hpp: the items of a set of modes.
#pragma once

#include <cca/graph/items/modes.hpp>
