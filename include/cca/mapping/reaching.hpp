// The status output of an inverse kinematics: whether the target was reached.
//
//   cca::wire<"ik.status", ...>;   if (s.is(cca::reaching::reached)) ...
//
// While a target is NaN or infinite, it is `unreadable`, and the angles stay (inverse_kinematics.hpp).
//
// It is a space of one axis without a rate, so it fits every input of its kind.
#pragma once

#include <cstdint>

#include <cca/space/methods/scalar.hpp>
#include <cca/space/space.hpp>

namespace cca {

enum class reaching : std::uint8_t {
  nothing,     // no sample yet
  reached,     // the angles lead to the target
  nearest,     // out of reach: they lead to the nearest point, and the search has ended
  unfinished,  // the search goes on in the next beats: they lead to the nearest point so far
  unreadable,  // the input was NaN or infinite: these are the last angles
};

struct solution : dimension<"solution"> {};
struct reaching_status : space<status, axes<solution>> {};

}  // namespace cca
