// A shorter path of verdict/diagnosis.hpp: what the compiler says of a graph.
#pragma once

#include <cca/graph/verdict/diagnosis.hpp>
