// What components ask of the loop of an environment for its parts, and other threads for the run: a pause.
// `Loop` is the loop.
#pragma once

#include <cstdint>

#include <cca/runtime/environments/links.hpp>

namespace cca::detail {

template <class Loop, class D, int E>
class asked_of_loop {
public:
  // To a recorder, if this environment has the first node of a part.
  void tell_part(int part, bool stops, bool requested, std::int64_t from) noexcept {
    if (plan_of<D>.nodes[array_size(first_node_of_part<D>(part))].environment == E)
      loop().tell([&](loop_tap& tap) { tap.part_changed(part, stops, requested, from); });
  }

  // At the end of a run: what was asked for in the beats before `beat`, and no more.
  void settle_parts(std::int64_t beat) {
    take_part_requests(beat);
    loop().state.requests.forget(loop().shared());
  }

protected:
  // Before beat `next`.
  void take_part_requests(std::int64_t next) noexcept {
    loop().state.requests.take(
        loop().shared(), loop().state, next,
        [this](int number, bool stops, std::int64_t from) { tell_part(number, stops, true, from); });
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
