// What asks live_access at a given place of a run: after a beat of the first environment, when the others
// have looked at their requests already.
#pragma once

#include <cstdint>

#include <cca/config.hpp>
#include <cca/deployment.hpp>
#include <cca/runtime/live/live_access.hpp>

namespace deployment_test {

template <class D, class F>
struct asking {
  cca::live_access<cca::deployed<D>>& live;
  F ask;  // ask(live, deployment)

  template <int Environment>
  void after_beat(cca::deployed<D>& d) {
    if constexpr (Environment == 0) ask(live, d);
    live.template after_beat<Environment>(d);
  }
  bool goes_on(cca::deployed<D>& d) { return live.goes_on(d); }
  bool is_over() const { return false; }
};

// In every few beats something else: which(beat), from 0; -1: nothing.
inline int which(std::int64_t beat, int of) {
  const auto h = static_cast<std::uint64_t>(beat / 3) * 0x9e3779b97f4a7c15ull >> 33;
  return beat % 3 == 1 && h % 3 == 0 ? static_cast<int>(h / 3 % static_cast<unsigned>(of)) : -1;
}

}  // namespace deployment_test
