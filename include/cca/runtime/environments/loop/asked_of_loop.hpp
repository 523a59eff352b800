// What is asked of the loop of an environment: by components and by other threads for its parts and its mode,
// and by other threads for the run, a pause.
// `Loop` is the loop.
#pragma once

#include <cstdint>

#include <cca/runtime/environments/links/links.hpp>

namespace cca::detail {

template <class Loop, class D, int E>
class asked_of_loop {
public:
  // To a recorder, if this environment has the first node of a part.
  void tell_part(int part, bool stops, bool requested, std::int64_t from) noexcept {
    if (plan_of<D>.nodes[array_size(first_node_of_part<D>(part))].place == E)
      loop().state.observers().part_changed(part, stops, requested, from);
  }

  // At the end of a run: what was asked for in the beats before `beat`, and no more; and all orders, before
  // beat `next`.
  void settle_changes(std::int64_t beat, std::int64_t next, bool may_switch) {
    loop().state.changes.settle(loop().shared(), loop(), beat, next, may_switch);
    loop().state.changes.forget(loop().shared());
  }

  // ---- for agreed_changes ----

  void make_requested(std::int64_t next) noexcept {
    if constexpr (parts_kept<loop_key<D, E>> > 0)
      loop().in_mode([&]<class Part>() {
        take_requests<Part>(loop().state, index_of(next),
                            [&](int number, bool stops) { tell_part(number, stops, true, next); });
      });
    if constexpr (DeploymentOfModes<D>) {
      const int mode = loop().state.requested;
      loop().state.forget_request();
      if (mode >= 0) loop().switch_mode(mode, next, true, true);
    }
  }
  void make_ordered(ordered what, int number, std::int64_t next) noexcept {
    if constexpr (DeploymentOfModes<D>)
      if (what == ordered::mode) return loop().switch_mode(number, next, false, true);
    set_part(number, what == ordered::stop, index_of(next), next);
  }
  void count_late_order(int from) noexcept { add(loop().own().late[array_size(from)], 1); }

  // As far as this environment, and the active mode, has it. `next`: the beat, or the cycle of a free-running
  // environment, from which on it counts; `from`: the beat for a recorder.
  void set_part([[maybe_unused]] int part,
                [[maybe_unused]] bool stops,
                [[maybe_unused]] std::int64_t next,
                [[maybe_unused]] std::int64_t from) {
    if constexpr (parts_kept<loop_key<D, E>> > 0) {
      if (!loop().has_part_now(part) || loop().state.parts[array_size(part)].is_stopped == stops) return;
      loop().in_mode([&]<class Part>() { change_part<Part>(loop().state, part, stops, next); });
      tell_part(part, stops, false, from);
    }
  }
  // Before beat `next`.
  void take_changes(std::int64_t next) noexcept { loop().state.changes.take(loop().shared(), loop(), next); }

protected:
  // What components have asked for in a beat, or in a cycle that began in it.
  void send_asked(std::int64_t beat) noexcept {
    auto& state = loop().state;
    if constexpr (is_free_running<D, E> && DeploymentOfModes<D>)
      if (!state.is_exact) loop().order_what_is_requested();
    if (loop().is_asked()) send_requests<D, E>(loop().shared(), state, beat, state.is_exact);
  }
  // A beat as this loop counts: a free-running environment counts cycles.
  std::int64_t index_of(std::int64_t beat) {
    if constexpr (is_free_running<D, E>) return loop().state.index;
    else return beat;
  }
  void tell_reached() noexcept { loop().state.observers().reached(loop().next_beat()); }
  void tell_skipped(std::int64_t first, std::int64_t count, bool by_clock) noexcept {
    loop().state.observers().skipped(first, count, by_clock);
  }

  // A pause: the others begin no beat either.
  template <class Obey>
  [[gnu::noinline]] void hold(Obey obey) {
    loop().own().is_paused.store(true, std::memory_order_release);
    loop().state.ring();
    if (!obey([this] { loop().idle(); }, [this] { return loop().goes_on(); })) loop().stop();
    loop().own().is_paused.store(false, std::memory_order_release);
    loop().state.ring();
  }

private:
  Loop& loop() { return static_cast<Loop&>(*this); }
};

}  // namespace cca::detail
