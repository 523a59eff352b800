// Where a loop keeps the observer of its beats.
#pragma once

#include <cca/base/inlining.hpp>
#include <cca/graph/marks/traceable.hpp>
#include <cca/runtime/observers/trace_track.hpp>

namespace cca::detail {

// A copy is not traced. What gets the value of another loop goes on being traced.
class trace_pointer {
public:
  trace_pointer() = default;
  trace_pointer(const trace_pointer&) noexcept {}
  // NOLINTNEXTLINE(bugprone-unhandled-self-assignment): nothing is assigned
  trace_pointer& operator=(const trace_pointer&) noexcept { return *this; }
  ~trace_pointer() {
    if (track) track->controller_is_gone();
  }
  trace_track* get() const noexcept { return track; }
  void set(trace_track* to) noexcept { track = to; }

private:
  trace_track* track = nullptr;
};

// A base of the state of a loop.
template <class Graph, bool HasHooks = has_trace_hooks<Graph>>
struct trace_link {};
template <class Graph>
struct trace_link<Graph, true> {
  trace_pointer trace{};
};

// Null where nobody traces, and always where the beat has no hooks.
template <class Graph, class State>
CCA_INLINE trace_track* trace_of([[maybe_unused]] const State& state) {
  if constexpr (has_trace_hooks<Graph>) return state.trace.get();
  else return nullptr;
}

}  // namespace cca::detail
