// How a system answers a step: rise time, overshoot, settling time.
//
//   const auto step = cca::step_response(angle, 1000, 0.1);   // samples from the step on, Hz, its height
//   step.rise_time, step.overshoot, step.settling_time, step.gain
//
//   gain            the change of the output that stays, per unit of the step
//   rise_time       s, from 10 % of that change to 90 %
//   overshoot       how much the largest change exceeds it, as a share; 0: not at all
//   settling_time   s, from the step until the output stays within 2 % of that change
//
// The output begins with its first sample; where it stays is the mean of the last tenth of the record. Works
// outside of the loop. A sample that is not finite, and an output that does not change, are refused
// (cca::refused). Source: Franklin, Powell and Emami-Naeini, Feedback Control of Dynamic Systems, 2015,
// section 3.4.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include <cca/base/refused.hpp>

namespace cca {

struct step_figures {
  double gain = 0, rise_time = 0, overshoot = 0, settling_time = 0;
};

inline step_figures step_response(std::span<const double> output, double rate, double height) {
  if (output.size() < 20) throw refused("step_response: expected at least 20 samples");
  if (!(rate > 0 && rate < 1e12)) throw refused("step_response: expected the rate of the samples in Hz");
  if (!(height > 0 || height < 0)) throw refused("step_response: expected the height of the step, not 0");
  for (const double one : output)
    if (!(one > -1e150 && one < 1e150)) throw refused("step_response: a sample is no finite number");
  const std::size_t tail = output.size() / 10;
  double end = 0;
  for (const double one : output.last(tail)) end += one / static_cast<double>(tail);
  const double change = end - output[0];
  if (!(change * height > 0 || change * height < 0))
    throw refused("step_response: the output does not change: was the step wired to it?");
  const auto share = [&](std::size_t n) { return (output[n] - output[0]) / change; };
  // When it reaches a share first, between two samples.
  const auto reaches = [&](double level) {
    std::size_t n = 1;
    while (n + 1 < output.size() && share(n) < level) ++n;
    const double before = share(n - 1), rise = share(n) - before;
    return (static_cast<double>(n - 1) + (rise > 0 ? std::clamp((level - before) / rise, 0.0, 1.0) : 1)) /
           rate;
  };
  double most = 0;
  std::size_t settled = 0;
  for (std::size_t n = 0; n < output.size(); ++n) {
    most = std::max(most, share(n));
    if (share(n) < 0.98 || share(n) > 1.02) settled = n + 1;
  }
  return {change / height, reaches(0.9) - reaches(0.1), std::max(0.0, most - 1),
          static_cast<double>(settled) / rate};
}

}  // namespace cca
