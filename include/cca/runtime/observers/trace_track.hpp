// The events of one loop on their way to the thread that writes them: one writer, one reader, wait-free. A
// beat that would not fit whole is left out, and counted. All memory is allocated in the constructor.
//
// The hooks read the clock and are functions of their own, so that a beat that is not traced has only a test
// for each.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <cca/base/monotonic_clock.hpp>
#include <cca/component/lifecycle.hpp>
#include <cca/runtime/observers/trace_event.hpp>

namespace cca::detail {

class trace_track {
public:
  struct room {
    std::size_t events = 0;   // at least
    std::size_t in_beat = 0;  // the most of one beat
    std::size_t words = 0;    // of a frame that nobody reads: recordable graphs write one
    bool waits = false;       // where there is no room, the loop waits: it is a fast run
  };
  explicit trace_track(const room& r)
      : most_in_beat(r.in_beat),
        size(std::bit_ceil(std::max(r.events, 4 * r.in_beat))),
        memory(size),
        frame(r.words),
        waits(r.waits) {}
  trace_track(const trace_track&) = delete;
  trace_track& operator=(const trace_track&) = delete;

  // ---- the loop's ----

  // `names`: what is added to the numbers of calls; a set of modes has names for each mode.
  [[gnu::noinline]] void begin(std::int64_t k, std::int32_t names = 0) noexcept {
    is_kept = has_room(most_in_beat);
    begun = last = monotonic_clock::now();
    if (!is_kept) return lose();
    beat = k;
    first_name = names;
    if (lost_in_a_row == 0) return;
    put({lost_since, begun, {lost_in_a_row}, 0, trace_kind::lost});
    lost_in_a_row = 0;
  }
  // A call is over. The time since the call before is its own.
  [[gnu::noinline]] void fired(std::int32_t call) noexcept {
    put_part(first_name + call, trace_kind::firing);
  }
  // What took the time since then is no call: samples that arrive.
  [[gnu::noinline]] void pass() noexcept { last = monotonic_clock::now(); }
  // The same, where it waited for another environment.
  [[gnu::noinline]] void waited() noexcept {
    if (monotonic_clock::now() - last < shortest_wait) pass();
    else put_part(0, trace_kind::wait);
  }
  [[gnu::noinline]] void end() noexcept {
    last = monotonic_clock::now();
    if (is_kept) put({begun, last, {beat}, 0, trace_kind::beat});
    commit();
    while (waits && !has_room(most_in_beat) && !is_abandoned.load(std::memory_order_acquire))
      monotonic_clock::sleep_until(monotonic_clock::now() + 100'000);
  }

  // ---- between two beats ----

  // The last beat was still running when the next should begin.
  void overrun(std::int64_t periods) noexcept { mark({last, last, {periods}, 0, trace_kind::overrun}); }
  void late(int environment) noexcept { mark(now(environment, trace_kind::late)); }
  void failed(int node, const char* reason) noexcept {
    trace_event one = now(node, trace_kind::fault);
    one.reason = reason;
    mark(one);
  }
  void moved(state to) noexcept { mark(now(static_cast<std::int32_t>(to), trace_kind::state)); }
  void switched(int mode) noexcept { mark(now(mode, trace_kind::mode)); }

  std::int64_t* unread_frame() noexcept { return frame.data(); }
  void controller_is_gone() noexcept { is_detached = true; }

  // ---- the reader's ----

  // Calls f(event) for those that are there.
  template <class F>
  void take(F f) {
    const std::uint64_t end = written.load(std::memory_order_acquire);
    std::uint64_t n = taken.load(std::memory_order_relaxed);
    for (; n < end; ++n) {
      f(memory[n & (size - 1)]);
      if (n % 64 == 0) taken.store(n, std::memory_order_release);
    }
    taken.store(n, std::memory_order_release);
  }
  // Nobody reads any more: the loop must not wait.
  void abandon() noexcept { is_abandoned.store(true, std::memory_order_release); }

  std::int64_t lost_beats() const noexcept { return lost.load(std::memory_order_relaxed); }
  std::int64_t lost_marks() const noexcept { return unmarked.load(std::memory_order_relaxed); }
  // Of the last beats, while the loop rests: those that no event tells of.
  std::int64_t untold_beats() const noexcept { return lost_in_a_row; }
  bool has_controller() const noexcept { return !is_detached; }

private:
  static constexpr std::int64_t shortest_wait = 1000;  // ns

  bool has_room(std::size_t events) const noexcept {
    return size - (at - taken.load(std::memory_order_acquire)) >= events;
  }
  static trace_event now(std::int32_t what, trace_kind kind) noexcept {
    const std::int64_t time = monotonic_clock::now();
    return {time, time, {0}, what, kind};
  }
  void put(const trace_event& e) noexcept { memory[at++ & (size - 1)] = e; }
  void put_part(std::int32_t what, trace_kind kind) noexcept {
    if (!is_kept) return;
    const std::int64_t time = monotonic_clock::now();
    put({last, time, {0}, what, kind});
    last = time;
  }
  void mark(const trace_event& e) noexcept {
    if (has_room(1)) put(e), commit();
    else unmarked.store(unmarked.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }
  void commit() noexcept { written.store(at, std::memory_order_release); }
  void lose() noexcept {
    if (lost_in_a_row++ == 0) lost_since = begun;
    lost.store(lost.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }

  std::size_t most_in_beat, size;
  std::vector<trace_event> memory;
  std::vector<std::int64_t> frame;
  bool waits = false, is_kept = false, is_detached = false;
  std::int32_t first_name = 0;
  std::uint64_t at = 0;  // the next event
  std::int64_t beat = 0, begun = 0, last = 0;
  std::int64_t lost_in_a_row = 0, lost_since = 0;
  std::atomic<bool> is_abandoned{false};
  std::atomic<std::int64_t> lost{0}, unmarked{0};
  alignas(64) std::atomic<std::uint64_t> written{0};
  alignas(64) std::atomic<std::uint64_t> taken{0};
};

}  // namespace cca::detail
