// When frames arrived, on the monotonic clock, from stamps of the real-time clock.
//
// The real-time clock may be set, also between a stamp and now. So a time is never in the future of the
// monotonic clock, and never before that of the frame before it. Source: Linux, Documentation/networking/
// timestamping.rst. Test: tests/runtime/hardware/arrival_clock.cpp.
#pragma once

#include <algorithm>
#include <cstdint>

namespace cca::hardware::detail {

class arrival_clock {
public:
  // All in nanoseconds: the kernel's stamp, and both clocks when the frame was read.
  constexpr std::int64_t operator()(std::int64_t stamped, std::int64_t real, std::int64_t monotonic) {
    last = std::min(monotonic, std::max(last, stamped - real + monotonic));
    return last;
  }

private:
  std::int64_t last = 0;
};

}  // namespace cca::hardware::detail
