// What a recorder is to a controller: the frames into which the beat writes, and what the controller tells it
// between two beats. A recorder derives from it; a controller holds a pointer to it, or none.
#pragma once

#include <cstdint>
#include <utility>

#include <cca/component/lifecycle.hpp>
#include <cca/graph/recordable.hpp>
#include <cca/runtime/recording/frame_layout.hpp>
#include <cca/runtime/recording/frame_ring.hpp>
#include <cca/runtime/tracing/trace_link.hpp>
#include <cca/space/origin.hpp>

namespace cca::detail {

// runtime/state.hpp
template <class Graph>
struct controller_state;
template <class Graph, int First>
struct array_of_components;
template <class Graph, int Array>
struct array_of_samples;

template <class Graph>
class beat_tap {
public:
  explicit beat_tap(std::size_t frames) : ring(frames) {}
  beat_tap(const beat_tap&) = delete;
  beat_tap& operator=(const beat_tap&) = delete;
  virtual ~beat_tap() = default;

  // The frame of a beat. What is published in each beat needs no mark.
  CCA_INLINE std::int64_t* begin(std::int64_t k) noexcept {
    std::int64_t* const frame = ring.frame();
    frame[0] = k;
    forget<chosen<counts_of<Graph>.output_count, is_seldom<Graph>>>::in(frame);
    return frame;
  }
  CCA_INLINE void end() noexcept {
    if (!ring.commit()) [[unlikely]]
      wait_for_room();
  }

  // ---- between two beats, or at the end of one, in the thread of the loop: no allocation, no wait ----

  virtual void parameters_changed(const controller_state<Graph>&, std::int64_t k) noexcept = 0;
  virtual void moved(state to, std::int64_t k) noexcept = 0;
  virtual void failed(int node, const char* reason, std::int64_t k) noexcept = 0;
  // The controller is destroyed, or gets the value of another one.
  virtual void controller_is_gone() noexcept = 0;

protected:
  // The next frame would be lost.
  virtual void wait_for_room() noexcept {}

  frame_ring<frame_layout_of<Graph>.words> ring;
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

// The state of a recordable graph is that of the graph, and this.
template <class Graph>
struct controller_state<probed<Graph>> : controller_state<Graph>, trace_link<probed<Graph>> {
  tap_pointer<Graph> tap{};
  std::int64_t* frame = nullptr;  // of this beat
};

template <class Graph, int First>
struct array_of_components<probed<Graph>, First> {
  using type = typename array_of_components<Graph, First>::type;
};
template <class Graph, int Array>
struct array_of_samples<probed<Graph>, Array> {
  using type = typename array_of_samples<Graph, Array>::type;
};

}  // namespace cca::detail
