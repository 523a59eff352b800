// A shorter path of items/inner_wires.hpp: policies of inner wires.
#pragma once

#include <cca/graph/items/inner_wires.hpp>
