// A shorter path of items/shows.hpp: what a user asks of a graph's ports.
#pragma once

#include <cca/graph/items/shows.hpp>
