// The spaces of what skeletons are told and tell besides data: at whatever rate, so that any writer's space
// of the same domain type over `x` matches.
#pragma once

#include <cca/space/domain.hpp>
#include <cca/space/space.hpp>

namespace cca {

struct choice : space<status, axes<x>> {
};  // a number of a source, counted from 0 in the order in which they are named
struct flag : space<status, axes<x>> {};  // 0: no; anything else: yes

}  // namespace cca
