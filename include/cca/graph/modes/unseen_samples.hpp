// A component that fires with each sample of its only input finds it where it was returned, in the beat. In a
// set of modes that does not always do: if the component comes at a switch, or was fed or fired in another
// way before, it has not seen what was published until then. So that must be stored.
//
// Cost: for such an output two stores for each number, in all modes.
#pragma once

#include <cca/graph/modes/same_commands.hpp>

namespace cca::detail {

// If its clock is known, it fires by that.
constexpr bool fires_with_each_sample(const mode_view& view, const input& in) {
  return in.in_beat && in.delay == 0 && !is_queued(in) && view.g.calls[in.call].own_clock.dynamic();
}

constexpr bool has_call(const mode_view& view, int shared_call) {
  for (int c = 0; c < view.g.call_count; ++c)
    if (view.shared_call(c) == shared_call) return true;
  return false;
}

// Does a mode have the same reader of the same output?
constexpr bool has_such_reader(const mode_view& other, const mode_view& view, const input& in) {
  for (int i = 0; i < other.g.first_link; ++i)
    if (const auto& one = other.g.inputs[i]; one.port == in.port && fires_with_each_sample(other, one) &&
                                             other.shared_call(one.call) == view.shared_call(in.call) &&
                                             other.shared_output(one.writer) == view.shared_output(in.writer))
      return true;
  return false;
}

// `view_of(m)`: mode m. A mode without the writer leaves nothing that could be seen.
template <class ViewOf>
constexpr bool may_be_unseen(const mode_view& view, int output, int mode_count, ViewOf view_of) {
  const auto& out = view.g.outputs[output];
  for (int i = out.first_reader; i >= 0; i = view.g.inputs[i].next_of_writer) {
    if (!fires_with_each_sample(view, view.g.inputs[i])) continue;
    for (int m = 0; m < mode_count; ++m)
      if (const mode_view other = view_of(m);
          has_call(other, view.shared_call(out.call)) && !has_such_reader(other, view, view.g.inputs[i]))
        return true;
  }
  return false;
}

}  // namespace cca::detail
