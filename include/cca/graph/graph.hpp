// A shorter path of items/graph.hpp: the items of a graph.
#pragma once

#include <cca/graph/items/graph.hpp>
