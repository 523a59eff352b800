// How an inverse kinematics fared: its status output.
//
//   cca::wire<"ik.status", ...>;   if (s.is(cca::reaching::reached)) ...
//
// A space of one axis without a rate, so that it can be wired to any input of the kind.
#pragma once

#include <cstdint>

#include <cca/space/scalar.hpp>
#include <cca/space/space.hpp>

namespace cca {

enum class reaching : std::uint8_t {
  nothing,     // no sample yet
  reached,     // the angles lead where they should
  nearest,     // it's out of reach: they lead to the nearest point that the solver knows
  unfinished,  // the iterations ran out; they lead nearer than the last
  unreadable,  // the input was NaN or infinite: the angles are those from before
};

struct solution : dimension<"solution"> {};
struct reaching_status : space<status, axes<solution>> {};

}  // namespace cca
