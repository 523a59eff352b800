// Who observes a loop: a tracer, a recorder, both or none. A loop tells what happens once, here, and it goes
// to all who observe. Whoever else is to observe a loop is added here.
//
// In the thread of the loop: no allocation, no wait, no lock. Where the graph is neither traceable nor
// recordable nothing of this is left.
#pragma once

#include <cstdint>

#include <cca/base/inlining.hpp>
#include <cca/component/lifecycle.hpp>
#include <cca/graph/marks/recordable.hpp>
#include <cca/graph/marks/traceable.hpp>
#include <cca/runtime/observers/beat_tap.hpp>
#include <cca/runtime/observers/trace_link.hpp>

namespace cca::detail {

// Null where nobody observes, and always where the graph has no hooks. Beat `k` is the next one, or the one
// that ends.
struct loop_observers {
  trace_track* track = nullptr;
  loop_tap* tap = nullptr;

  CCA_INLINE void moved(state to, std::int64_t k) const noexcept {
    if (track) track->moved(to);
    if (tap) tap->moved(to, k);
  }
  CCA_INLINE void failed(int node, const char* reason, std::int64_t k) const noexcept {
    if (track) track->failed(node, reason);
    if (tap) tap->failed(node, reason, k);
  }
  // `requested`: by a component.
  CCA_INLINE void switched(int mode, bool requested, std::int64_t k) const noexcept {
    if (track) track->switched(mode);
    if (tap) tap->switched(mode, requested, k);
  }
  CCA_INLINE void part_changed(int part, bool stops, bool requested, std::int64_t k) const noexcept {
    if (tap) tap->part_changed(part, stops, requested, k);
  }
  // The last beat was still running when the next should begin.
  CCA_INLINE void overrun(std::int64_t periods) const noexcept {
    if (track) track->overrun(periods);
  }

  // Of an environment (observers/beat_tap.hpp).
  CCA_INLINE void late(int environment, std::int64_t k) const noexcept {
    if (track) track->late(environment);
    if (tap) tap->late(environment, k);
  }
  CCA_INLINE void skipped(std::int64_t k, std::int64_t count, bool by_clock) const noexcept {
    if (tap) tap->skipped(k, count, by_clock);
  }
  CCA_INLINE void runs_freely(std::int64_t k, bool freely) const noexcept {
    if (tap) tap->runs_freely(k, freely);
  }
  CCA_INLINE void reached(std::int64_t k) const noexcept {
    if (tap) tap->reach(k);
  }
};

// Of a beat with this key.
template <class Key, class State>
CCA_INLINE loop_observers observers_in([[maybe_unused]] const State& state) {
  loop_observers all{trace_of<Key>(state)};
  if constexpr (is_probed<Key>) all.tap = state.tap.get();
  return all;
}

// Around a beat: a frame for a recorder, and the time for a tracer. `first_name`: trace_track::begin.
template <class Key, class State>
CCA_INLINE frame_of_beat<Key> begin_observed([[maybe_unused]] const State& state,
                                             [[maybe_unused]] std::int64_t k,
                                             std::int32_t first_name = 0) {
  frame_of_beat<Key> begun;
  if constexpr (is_probed<Key>) begun.frame = state.begin_frame(k);
  if (auto* const track = trace_of<Key>(state)) [[unlikely]]
    track->begin(k, first_name);
  return begun;
}
template <class Key, class State>
CCA_INLINE void end_observed([[maybe_unused]] const State& state,
                             [[maybe_unused]] frame_of_beat<Key> begun,
                             [[maybe_unused]] bool has_frame = true) {
  if (auto* const track = trace_of<Key>(state)) [[unlikely]]
    track->end();
  if constexpr (is_probed<Key>) state.end_frame(begun.frame, has_frame);
}

}  // namespace cca::detail
