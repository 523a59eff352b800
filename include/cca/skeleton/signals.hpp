// The spaces of a skeleton's choices and flags. They state no rate, so any space of status over `x` matches.
#pragma once

#include <cca/space/domain.hpp>
#include <cca/space/space.hpp>

namespace cca {

// The number of a source, counted from 0 in the order of their names.
struct choice : space<status, axes<x>> {};

// 0: no; anything else: yes.
struct flag : space<status, axes<x>> {};

}  // namespace cca
