// The last three samples of a demonstration, if they came in consecutive firings: enough for position,
// velocity and acceleration at the middle one, by central differences.
//
//   if (shown.fresh()) { if (seen.add({y, x})) ... seen[1] ... } else seen.interrupt();
//
// A sample that is NaN or infinite makes the differences NaN, which a training ignores; or interrupt there.
#pragma once

#include <array>
#include <cstddef>

namespace cca::detail {

template <class Moment>
class three_in_a_row {
public:
  // True if there are three. docs/compilers.md says why it is inlined.
  [[gnu::always_inline]] bool add(const Moment& newest) {
    last = {last[1], last[2], newest};
    return ++count >= 3;
  }
  void interrupt() { count = 0; }
  // From the oldest (0) to the newest (2).
  const Moment& operator[](std::size_t i) const { return last[i]; }

private:
  std::array<Moment, 3> last{};
  int count = 0;
};

}  // namespace cca::detail
