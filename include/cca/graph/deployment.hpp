// A shorter path of items/deployment.hpp: the items of a deployment.
#pragma once

#include <cca/graph/items/deployment.hpp>
