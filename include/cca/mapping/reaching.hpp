// The status output of an inverse kinematics: whether the target was reached.
//
//   cca::wire<"ik.status", ...>;   if (s.is(cca::reaching::reached)) ...
//
// While a target is NaN or infinite, it is `unreadable`, and the angles stay (inverse_kinematics.hpp).
//
// It is a space of one axis without a rate, so it fits every input of its kind.
#pragma once

#include <cstdint>
#include <string>

#include <cca/base/after_run.hpp>
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

namespace detail {

// Counts what was not reached, whether the status is read or not.
struct reaching_counts {
  std::int64_t nearest = 0, unfinished = 0, unreadable = 0;
  double farthest = 0;  // m

  // A target that moves is never given up: one that is always out of reach stays `unfinished`.
  void add(reaching status, double distance) {
    ++(status == reaching::nearest ? nearest : unfinished);
    if (distance > farthest) farthest = distance;
  }
  std::string summary() const {
    std::string text;
    if (nearest > 0)
      text = formatted("%lld times the target was out of reach", static_cast<long long>(nearest));
    if (unfinished > 0)
      text += formatted("%s%lld times it was not reached yet", text.empty() ? "" : ", ",
                        static_cast<long long>(unfinished));
    if (!text.empty()) text += formatted(", the farthest by %.4g m: see its `status`", farthest);
    if (unreadable > 0)
      text += formatted("%s%lld times the target was not finite", text.empty() ? "" : "; ",
                        static_cast<long long>(unreadable));
    return text;
  }
};

}  // namespace detail

}  // namespace cca
