// A shorter path of marks/recordable.hpp: a graph that may be recorded.
#pragma once

#include <cca/graph/marks/recordable.hpp>
