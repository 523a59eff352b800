// The events of a trace, in the memory between the loop and the thread that writes.
#pragma once

#include <cstdint>

#include <cca/component/component.hpp>

namespace cca::detail {

enum class trace_kind : std::int32_t {
  firing,   // what: the number of the call
  beat,     // value: its number
  wait,     // in a beat, for other environments
  lost,     // value: beats that did not fit
  overrun,  // value: periods without a beat
  late,     // what: the environment whose samples had not come
  fault,    // what: the component, or -1; reason
  state,    // what: the new state
  mode      // what: the new mode
};

// The number of a call: of `sense` or `process` of a node, or of its `act`.
constexpr std::int32_t trace_name(int node, phase_of_beat phase) {
  return 2 * node + (phase == phase_of_beat::act ? 1 : 0);
}

struct trace_event {
  std::int64_t begin = 0, end = 0;  // ns of the monotonic clock; equal: a moment
  union {
    std::int64_t value = 0;
    const char* reason;  // static text
  };
  std::int32_t what = 0;
  trace_kind kind{};
};

}  // namespace cca::detail
