// What a recorder is to a loop: the frames into which the beat writes, and what the loop tells it between two
// beats. A recorder derives from it; a loop holds a pointer to it, or none.
#pragma once

#include <atomic>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <cca/component/lifecycle.hpp>
#include <cca/graph/marks/recordable.hpp>
#include <cca/runtime/observers/frame_layout.hpp>
#include <cca/runtime/observers/frame_ring.hpp>
#include <cca/runtime/observers/trace_link.hpp>
#include <cca/space/origin.hpp>

namespace cca::detail {

// runtime/state.hpp
template <class Graph>
struct controller_state;
template <class Graph, int First>
struct array_of_components;
template <class Graph, int Array>
struct array_of_samples;
template <class Graph, int Call>
struct place_of_strategy;

// What all loops tell, between two beats or at the end of one, in the thread of the loop: no allocation, no
// wait.
class loop_tap {
public:
  loop_tap() = default;
  loop_tap(const loop_tap&) = delete;
  loop_tap& operator=(const loop_tap&) = delete;
  virtual ~loop_tap() = default;

  virtual void moved(state to, std::int64_t k) noexcept = 0;
  virtual void failed(int node, const char* reason, std::int64_t k) noexcept = 0;
  // The controller is destroyed, or gets the value of another one.
  virtual void controller_is_gone() noexcept = 0;

  // Of a set of modes: the next beat is in this mode. `requested`: a component asked for it.
  virtual void switched(int /*mode*/, bool /*requested*/, std::int64_t /*k*/) noexcept {}
  // From beat k on a part rests, or runs again. `requested`: a component asked for it.
  virtual void part_changed(int /*part*/, bool /*stops*/, bool /*requested*/, std::int64_t /*k*/) noexcept {}
  // Of a deployment: from beat k on its free-running environments run freely, in a wall-clock run. Of one of
  // modes also: not so, in a fast run.
  virtual void runs_freely(std::int64_t /*k*/, bool /*freely*/) noexcept {}
  // Of an environment: beat k began without the samples of another one; `count` beats from k on do not run,
  // because of the clock or of a fault.
  virtual void late(int /*environment*/, std::int64_t /*k*/) noexcept {}
  virtual void skipped(std::int64_t /*k*/, std::int64_t /*count*/, bool /*by_clock*/) noexcept {}

  // Of an environment: all that it tells of the beats before k is there.
  void reach(std::int64_t k) noexcept { next_beat.store(k, std::memory_order_release); }
  std::int64_t reached() const noexcept { return next_beat.load(std::memory_order_acquire); }

private:
  std::atomic<std::int64_t> next_beat{0};
};

template <class Graph>
class beat_tap : public loop_tap {
public:
  explicit beat_tap(std::size_t frames) : ring(frames) {}

  // The frame of a beat, in which nothing is published yet.
  CCA_INLINE std::int64_t* begin(std::int64_t k) noexcept {
    std::int64_t* const frame = ring.frame();
    frame[0] = k;
    return frame;
  }
  CCA_INLINE void end(std::int64_t* frame) noexcept {
    if (!ring.commit(frame)) [[unlikely]]
      has_no_room();
  }
  // The beat has no frame after all.
  void drop() noexcept { ring.drop(); }

  virtual void parameters_changed(const controller_state<Graph>&, std::int64_t k) noexcept = 0;

protected:
  // For the frame of a beat.
  virtual void has_no_room() noexcept { ring.drop(); }

  frame_ring<frame_layout_of<Graph>.words, frame_layout_of<Graph>.origins> ring;
};

// A copy of a controller is not recorded. The recording of a controller ends when another one is assigned to
// it.
template <class Graph>
class tap_pointer {
public:
  tap_pointer() = default;
  tap_pointer(const tap_pointer&) {}
  tap_pointer& operator=(const tap_pointer& other) {
    if (this != &other && tap) std::exchange(tap, nullptr)->controller_is_gone();
    return *this;
  }
  ~tap_pointer() {
    if (tap) tap->controller_is_gone();
  }
  beat_tap<Graph>* get() const noexcept { return tap; }
  void set(beat_tap<Graph>* to) noexcept { tap = to; }

private:
  beat_tap<Graph>* tap = nullptr;
};

// Where a beat finds its frame. `State` is what it is a base of.
template <class State, class Graph>
struct frame_link {
  tap_pointer<Graph> tap{};

  bool is_observed() const noexcept {
    if constexpr (has_trace_hooks<probed<Graph>>)
      if (self().trace.get()) return true;
    return tap.get() != nullptr;
  }
  // Where it is only traced, the frame is one that nobody reads.
  CCA_INLINE std::int64_t* begin_frame(std::int64_t k) const noexcept {
    auto* const to = tap.get();
    if constexpr (has_trace_hooks<probed<Graph>>)
      if (!to) return self().trace.get()->unread_frame();
    return to->begin(k);
  }
  CCA_INLINE void end_frame(std::int64_t* frame, bool is_kept) const noexcept {
    auto* const to = tap.get();
    if constexpr (has_trace_hooks<probed<Graph>>)
      if (!to) return;
    if (is_kept) to->end(frame);
    else to->drop();
  }

private:
  const State& self() const noexcept { return static_cast<const State&>(*this); }
};

// The state of a recordable graph is that of the graph, and this.
template <class Graph>
struct controller_state<probed<Graph>> : controller_state<Graph>,
                                         trace_link<probed<Graph>>,
                                         frame_link<controller_state<probed<Graph>>, Graph> {};

// What a loop keeps.
template <class Graph>
using kept_state =
    std::conditional_t<Recordable<Graph>, controller_state<probed<Graph>>, controller_state<Graph>>;

template <class Graph, int First>
struct array_of_components<probed<Graph>, First> {
  using type = typename array_of_components<Graph, First>::type;
};
template <class Graph, int Call>
struct place_of_strategy<probed<Graph>, Call> : place_of_strategy<Graph, Call> {};
template <class Graph, int Array>
struct array_of_samples<probed<Graph>, Array> {
  using type = typename array_of_samples<Graph, Array>::type;
};

}  // namespace cca::detail
