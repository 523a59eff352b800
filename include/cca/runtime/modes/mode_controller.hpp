// The controller of a set of modes. It is like that of one graph; one mode is active, at first the first.
//
//   cca::controller<legs> c;
//   c.load(); c.start();
//   c.switch_to<"stand">();          // between two beats; by a name known at run time: c.switch_to("stand")
//   c.mode();                        // "stand"
//
// `load`, `save`, `get` and `set` work on the components of all modes, active or not. `start` and `stop` call
// the hooks of the active mode. A switch between two beats stops what the next mode lacks and starts what the
// last one lacked; in a controller that is not started no hook runs. A component that is stopped on its own
// stays so in the next mode, unless it comes. Errors: modes.*; `cca::refused`: a name of no mode, a switch
// after a fault, and to stop or start one component that the active mode lacks. Cost: docs/modes.md.
//
// Threads: all member functions, those of the bases too (run, step, get, set, load, save, resume, state), are
// for one thread at a time. While it runs that is the thread that called `run`, in `between`. Other threads
// use cca::live_access.
#pragma once

#include <string>
#include <string_view>

#include <cca/graph/modes/diagnosis_of_modes.hpp>
#include <cca/runtime/controller.hpp>
#include <cca/runtime/modes/mode_names.hpp>
#include <cca/runtime/modes/mode_switch.hpp>

namespace cca {

template <class M>
  requires Modes<M> && detail::WellFormed<M>
class controller<M> : public detail::loop_host<controller<M>, M>, detail::mode_names<M> {
  using host = detail::loop_host<controller<M>, M>;
  using names = detail::mode_names<M>;
  using names::all, names::mode_named, names::number_of;

public:
  // ---- the thread that runs the beats, between two of them ----

  using host::start;  // one component
  using host::stop;

  void start() {
    const hooks_of_active_mode now_on(*this);
    host::start();
  }
  void stop() {
    const hooks_of_active_mode now_on(*this);
    host::stop();
  }

  template <fixed_string Mode>
  void switch_to() {
    change_to(names::template mode_named<Mode>());
  }
  void switch_to(std::string_view mode) { change_to(number_of(mode)); }

  // The active one.
  std::string_view mode() const noexcept { return all.modes[active].name; }

  // As of a controller of the active mode, with the samples of the last beat.
  template <class F>
  void observed(F f) const {
    with_mode(active, [&]<int I>() { detail::observe_all<detail::mode_part<M, I>>(state_of_all, k, f); });
  }
  template <class F>
  void observed(F f) {
    with_mode(active, [&]<int I>() {
      detail::observe_all<detail::mode_part<M, I>>(state_of_all, k, f);
      detail::take_outside<detail::mode_part<M, I>>(state_of_all);
    });
  }
  template <class F>
  void observed_newest(F f) const {
    with_mode(active,
              [&]<int I>() { detail::observe_newest_of<detail::mode_part<M, I>>(state_of_all, k, f); });
  }

  void record_into(detail::beat_tap<M>* tap) noexcept
    requires(detail::Recordable<M>)
  {
    host::record_into(tap);
    if (tap) tap->switched(active, false, k);
  }

private:
  friend detail::component_host<controller, M>;
  friend detail::stoppable_parts<controller, M>;
  friend detail::dropped_samples<controller, M>;
  friend host;
  friend detail::live_components;
  template <int I>
  using part = detail::mode_part<M, I>;

  template <int Node>
  auto& component() {
    return detail::component_at<M, Node>(state_of_all);
  }
  template <int Node>
  const auto& component() const {
    return detail::component_at<M, Node>(state_of_all);
  }
  template <class F, class Controller>
  static void visit(F f, Controller& self) {
    detail::visit_components<M>(f, self.state_of_all);
  }
  // Its components are those of the active mode.
  template <class F, class Controller>
  static void for_each_part_state(int, F f, Controller& self) {
    with_mode(self.active, [&]<int I>() { f.template operator()<part<I>>(self.state_of_all, self.k); });
  }

  template <class F>
  void for_each_state(F f) const {
    f.template operator()<M>(state_of_all);
  }

  // Parameters are those of all modes, on_start and on_stop the active one's.
  bool is_here(int node) const { return !is_for_active_mode || is_active(node); }
  bool is_active(int node) const {
    return detail::has_mode(detail::plan_of<M>.nodes[detail::array_size(node)].members, active);
  }
  bool has_part(int number) const {
    return detail::has_mode(detail::plan_of<M>.parts[detail::array_size(number)].members, active);
  }
  void check_part(const char* call, int number) const {
    if (!has_part(number)) names::refuse_part(call, number, mode());
  }
  struct hooks_of_active_mode {
    controller& c;
    explicit hooks_of_active_mode(controller& of) : c(of) { c.is_for_active_mode = true; }
    ~hooks_of_active_mode() { c.is_for_active_mode = false; }
  };

  // Calls f.template operator()<I>() for the mode with this number.
  template <class F>
  CCA_INLINE static void with_mode(int mode, F f) {
    [&]<int... I>(std::integer_sequence<int, I...>) {
      (void)((mode == I && (f.template operator()<I>(), true)) || ...);
    }(std::make_integer_sequence<int, detail::mode_count<M>>{});
  }

  // Of an output that more than one mode has, once for each.
  template <class F>
  void observed_in_any_mode(F f) const {
    for (int m = 0; m < all.count; ++m)
      with_mode(m, [&]<int I>() { detail::observe_newest_of<detail::mode_part<M, I>>(state_of_all, k, f); });
  }

  void advance() noexcept {
    if constexpr (detail::is_always_probed<M>)
      with_mode(active, [this]<int I>() { this->template advance_replayed_in<I>(); });
    else {
      if constexpr (detail::Recordable<M>)
        if (state_of_all.is_observed())
          return with_mode(active,
                           [this]<int I>() { this->template advance_in<I, detail::probed<part<I>>>(); });
      with_mode(active, [this]<int I>() { this->template advance_in<I, part<I>>(); });
    }
  }

  // `Key`: the mode, or its second beat, which tells a recorder.
  template <int I, class Key>
  [[gnu::noinline]] CCA_BEAT void advance_in() noexcept {
    run_beat_in<I, Key>();
  }
  template <int I>
  [[gnu::noinline]] CCA_REPLAYED_BEAT void advance_replayed_in() noexcept {
    run_beat_in<I, detail::probed<part<I>>>();
  }
  template <int I, class Key>
  CCA_INLINE void run_beat_in() noexcept {
    detail::beat_outcome outcome;
    const std::int64_t beat = k;
    const auto frame = detail::begin_observed<Key>(
        state_of_all, beat,
        detail::trace_name(detail::first_node_of_mode<M, I>, detail::phase_of_beat::process));
    detail::run_beat_of_graph<Key>(state_of_all, outcome, beat, frame);
    detail::end_observed<Key>(state_of_all, frame);
    ++k;
    if constexpr (detail::counts_of<part<I>>.may_fault)
      if (outcome.fault) return fail_in<I>(outcome);
    if constexpr (detail::counts_of<part<I>>.request_count > 0)
      if (state_of_all.is_asked) [[unlikely]]
        take_requests<I>();
    if constexpr (detail::may_request<part<I>>)
      if (state_of_all.requested >= 0) [[unlikely]]
        switch_by_request();
  }

  // It stays in its mode, whatever a component asked for in this beat.
  template <int I>
  [[gnu::noinline]] void fail_in(detail::beat_outcome outcome) noexcept {
    detail::repeat_outputs<part<I>>(state_of_all, k - 1);
    detail::note_missed<part<I>>(state_of_all, k - 1, outcome.turns);
    state_of_all.requested = -1;
    if constexpr (detail::parts_kept<M> > 0) detail::forget_requests(state_of_all);
    outcome.node = detail::shared_nodes<M, I>[detail::array_size(outcome.node)];
    host::fail(outcome);
  }

  template <int I>
  [[gnu::noinline]] void take_requests() noexcept {
    detail::take_requests<part<I>>(state_of_all, k, [this](int number, bool stops) {
      this->observers().part_changed(number, stops, true, k);
    });
  }

  [[gnu::noinline]] void switch_by_request() noexcept {
    move_to(std::exchange(state_of_all.requested, -1), true);
  }

  void change_to(int next) {
    if (now == cca::state::faulted)
      throw refused("cca::controller: switch_to() is refused in the state `faulted`: " +
                    std::string(detail::remedy(detail::transition::run, now)));
    move_to(next);
  }

  void move_to(int next, bool is_requested = false) {
    if (next == active) return;
    const bool is_started = now == cca::state::started || now == cca::state::running;
    with_mode(active, [&]<int I>() { detail::mode_switch<M, I>{state_of_all}.leave(next, k, is_started); });
    const int last = active;
    active = next;
    this->observers().switched(next, is_requested, k);
    state_of_all.since = k;
    with_mode(next, [&]<int I>() { detail::mode_switch<M, I>{state_of_all}.enter(last, k, k, is_started); });
  }

  using host::k, host::now;

  detail::kept_state_of_modes<M> state_of_all;
  int active = 0;
  bool is_for_active_mode = false;
};

}  // namespace cca
