// A shorter path of marks/traceable.hpp: a graph whose beats may be traced.
#pragma once

#include <cca/graph/marks/traceable.hpp>
