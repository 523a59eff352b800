// The mode in which the loop of an environment is. A deployment of one graph has one, which costs nothing.
// `Loop` is the loop.
#pragma once

#include <cstdint>
#include <utility>

#include <cca/runtime/environments/links/links.hpp>
#include <cca/runtime/environments/loop/state_of_modes.hpp>

namespace cca::detail {

template <class Part>
struct deployment_of;
template <class D, int E>
struct deployment_of<part<D, E>> {
  using type = D;
};
template <class Part>
using deployment_of_part = typename deployment_of<Part>::type;

template <class Loop, class D, int E, bool HasModes = DeploymentOfModes<D>>
class mode_of_loop {
public:
  // f.template operator()<part>() for the part of the active mode.
  template <class F>
  CCA_INLINE void in_mode(F f) {
    f.template operator()<part<D, E>>();
  }
  template <class F>
  CCA_INLINE void in_mode(F f) const {
    f.template operator()<part<D, E>>();
  }
  static constexpr bool has_part_now(int) { return true; }
  // Beat k was cut.
  void settle_queues(std::int64_t k) { loop().state.settle_queues(k); }

protected:
  // The links, with the functions of a mode.
  template <class Part>
  CCA_INLINE auto& links_in() {
    return loop().state;
  }
  static constexpr std::int64_t first_of_mode() { return 0; }
  CCA_INLINE bool is_asked() const { return loop().state.is_asked; }
  CCA_INLINE void forget_asked() { forget_requests(loop().state); }
  template <class Part>
  static constexpr int node_of(int node) {
    return node;
  }
  template <class Part>
  static constexpr int first_trace_name() {
    return 0;
  }

private:
  Loop& loop() { return static_cast<Loop&>(*this); }
  const Loop& loop() const { return static_cast<const Loop&>(*this); }
};

template <class Loop, class D, int E>
class mode_of_loop<Loop, D, E, true> {
  using set = modes_in<D, E>;

public:
  template <class F>
  void in_mode(F f) {
    in_some_mode(loop().state.active, f);
  }
  template <class F>
  void in_mode(F f) const {
    in_some_mode(loop().state.active, f);
  }
  void settle_queues(std::int64_t k) {
    in_mode([&]<class Part>() { links_in<Part>().settle_queues(k); });
  }
  int mode() const noexcept { return loop().state.active; }
  std::int64_t switches() const noexcept { return switched; }

  bool tells_mode = false;  // a recorder

  // Between two beats; `next` is the first beat of the mode. `is_requested`: by a component. Not started: no
  // hook runs.
  void switch_mode(int to, std::int64_t next, bool is_requested, bool is_started) noexcept {
    auto& state = loop().state;
    const int last = state.active;
    if (to == last) return;
    const std::int64_t index = loop().index_of(next);
    with_mode(last, [&]<int I>() { mode_switch<set, I>{state}.leave(to, index, is_started); });
    state.active = to;
    state.since = index;
    first_beat = next;
    ++switched;
    loop().note_mode(last, to, next);
    loop_observers told = state.observers();
    if (!tells_mode) told.tap = nullptr;
    told.switched(to, is_requested, next);
    with_mode(to, [&]<int I>() { mode_switch<set, I>{state}.enter(last, index, next, is_started); });
  }
  // As other environments have switched, between two runs.
  void join_mode(int to, std::int64_t so_often, std::int64_t next, bool is_started) noexcept {
    switch_mode(to, next, false, is_started);
    switched = so_often;
  }
  // To a recorder that begins.
  void tell_mode(std::int64_t next) noexcept {
    if (loop_tap* const tap = loop().state.observers().tap; tap && tells_mode)
      tap->switched(mode(), false, next);
  }
  bool has_part_now(int part) const { return has_mode(plan_of<D>.parts[array_size(part)].members, mode()); }
  bool has_node_now(int node) const { return has_mode(plan_of<D>.nodes[array_size(node)].members, mode()); }

protected:
  template <class Part>
  auto& links_in() {
    return static_cast<environment_links<deployment_of_part<Part>, E>&>(loop().state);
  }
  std::int64_t first_of_mode() const { return first_beat; }
  bool is_asked() const {
    if constexpr (counts_of<D>.part_count > 0)
      if (loop().state.is_asked) return true;
    return loop().state.requested >= 0;
  }
  void forget_asked() {
    if constexpr (counts_of<D>.part_count > 0) forget_requests(loop().state);
    loop().state.forget_request();
  }
  // Of the beat that begins. False: contact was lost before.
  bool learn_mode() noexcept {
    auto& state = loop().state;
    if (!state.is_exact)
      if (const int lost = state.count_late(loop().k, state.observers()); lost >= 0)
        return loop().state_fault(state.observers(), 0, lost_contact<D>(lost), -1), false;
    loop().take_changes(loop().beat_that_begins());
    return true;
  }
  // What components of free-running environments have published arrives before a beat begins, and its mode
  // says whether it does.
  bool learn_mode_before_beat() noexcept { return is_mode_known = learn_mode(); }
  // First it learns which mode the beat is in.
  void run_beat_of_mode() noexcept {
    if (!is_mode_known && !learn_mode()) return;
    is_mode_known = false;
    in_mode([this]<class Part>() {
      if constexpr (Recordable<D>)
        if (this->loop().state.is_observed()) return this->template run<probed<Part>>();
      this->template run<Part>();
    });
  }
  // A component of a free-running environment asks for a mode in a wall-clock run: its cycles are no beats,
  // so that is an order. One in a beat is enough.
  void order_what_is_requested() noexcept {
    const int to = loop().state.requested;
    loop().state.forget_request();
    const std::int64_t next = loop().next_beat();
    if (to < 0 || to == (next <= ordered_for ? ordered_mode : mode()) || next == ordered_before) return;
    ordered_before = next;
    ordered_mode = to;
    ordered_for = beat_of_order<D>(next, false);
    send_order<D, E>(loop().shared(), ordered::mode, to, ordered_for, false);
  }
  // In the whole set.
  template <class Part>
  static int node_of(int node) {
    return node < 0 ? node : shared_nodes<D, mode_number_of<Part>>[array_size(node)];
  }
  // The calls of a mode are after those of the modes before.
  template <class Part>
  static constexpr int first_trace_name() {
    return trace_name(first_node_of_mode<D, mode_number_of<Part>>, phase_of_beat::process);
  }

private:
  // A function for each mode.
  template <class Key>
  [[gnu::noinline]] CCA_BEAT void run() noexcept {
    loop().template run_beat_of<Key>();
  }

  template <class F>
  static void with_mode(int number, F f) {
    [&]<int... I>(std::integer_sequence<int, I...>) {
      (void)((number == I && (f.template operator()<I>(), true)) || ...);
    }(std::make_integer_sequence<int, mode_count<D>>{});
  }
  template <class F>
  static void in_some_mode(int number, F& f) {
    with_mode(number, [&]<int I>() { f.template operator()<part<deployed_mode<D, I>, E>>(); });
  }

  Loop& loop() { return static_cast<Loop&>(*this); }
  const Loop& loop() const { return static_cast<const Loop&>(*this); }

  std::int64_t switched = 0;  // so often
  std::int64_t first_beat = 0;
  bool is_mode_known = false;                          // of the beat that begins
  std::int64_t ordered_before = -1, ordered_for = -1;  // beats
  int ordered_mode = -1;
};

}  // namespace cca::detail
