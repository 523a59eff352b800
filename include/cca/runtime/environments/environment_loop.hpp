// The loop of one environment: its components, which beats it runs, and when.
//
// A fast run waits for every sample that it needs, so that all is as in one loop. A run on a clock never
// waits for a sample: the first environment gives the beat, the others follow it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <cca/runtime/each_component.hpp>
#include <cca/runtime/environments/active_beats.hpp>
#include <cca/runtime/environments/links.hpp>
#include <cca/runtime/environments/lost_contact.hpp>
#include <cca/runtime/environments/waiting/beats_of_first.hpp>
#include <cca/runtime/cut_beat.hpp>
#include <cca/runtime/one_beat.hpp>
#include <cca/runtime/run_record.hpp>

namespace cca::detail {

template <class D, int E>
class alignas(64) environment_loop : beats_of_first<environment_loop<D, E>, D> {
  using graph = part<D, E>;
  using first_beats = beats_of_first<environment_loop, D>;
  friend first_beats;
  using first_beats::wait_for_beat;
  static constexpr std::int64_t period = counts_of<D>.period;

public:
  std::int64_t k = 0;     // the next beat; asleep, the next in which something can fire
  std::int64_t done = 0;  // behind the last beat that has run
  kept_state<graph> state;

  // Before a run, while all environments rest. `ahead`: of the others, as fast as possible.
  void prepare(
      exchange<D>& exchanged, const peers* others, bool is_exact, std::int64_t ahead, std::int64_t beat) {
    state.shared = &exchanged;
    state.others = others;
    state.rings = others ? others->rings() : nullptr;
    state.courier = is_exact && others && others->works_in_environment() ? others : nullptr;
    state.is_exact = is_exact;
    state.ahead = ahead;
    state.is_cut = false;
    state.forget_others();
    state.requests.forget(exchanged);
    has_handled_fault = false;
    skip_to(beat);
    state.begin_queues(beat);
    own().begun = beat - 1;
    own().begun_at[0] = own().begun_at[1] = own().interval = 0;
    own().slowest.forget();
    own().fault.position = no_position;
    own().stop_at = no_position;
    announce();
    if (E == 0 && ahead == 0) state.move_to(position() - 1);  // when its pace lets it begin
  }

  // `after_beat`, of the first environment in each process, returns false at the end.

  // ---- as fast as possible ----

  // Where no environment may be ahead, `after_beat` sees all environments at rest.
  template <class Pace, class AfterBeat>
  void lead_exactly(std::int64_t end, run_record& runs, Pace& pace, AfterBeat after_beat) {
    const std::int64_t first = k;
    while (k < end && wait_until_it_may_begin()) {
      runs.wait(pace, (k - first) * period);
      if (state.ahead == 0) announce();
      run_beat();
      if (state.ahead > 0) announce();
      else if (all_have_come() && !after_beat()) stop();
    }
  }

  template <class AfterBeat>
  void follow_exactly(std::int64_t end, AfterBeat after_beat) {
    while (!is_asleep_until(end) && wait_until_it_may_begin()) {
      run_beat();
      if (state.ahead == 0 && !after_beat()) stop();
      announce();
    }
  }

  // ---- at wall-clock speed ----

  template <class Pace, class AfterBeat>
  void lead(std::int64_t end, run_record& runs, Pace& pace, AfterBeat after_beat) {
    const std::int64_t first = k;
    while (k < end && goes_on()) {  // a beat that a fault has cut is no overrun
      const cca::fault late = wait(runs, pace, (k - first) * period);
      own().overruns.store(runs.overruns, std::memory_order_relaxed);
      own().lost_periods.store(runs.lost_periods, std::memory_order_relaxed);
      if (late) state_fault(state.observers(), 0, late.reason(), -1);
      if (!goes_on()) return;
      own().begun_at[own().slot_of(k)].store(pace.last_begun(), std::memory_order_relaxed);
      own().interval.store(pace.duration_of(period), std::memory_order_relaxed);
      own().begun.store(k, std::memory_order_release);
      state.ring();
      run_timed_beat();
      announce();
      if (!after_beat()) stop();
    }
  }

  // A beat that is still running when the next should begin is an overrun; the next begins with the first
  // environment's next beat. It is the newest that is due: those in between are lost.
  template <class AfterBeat>
  void follow(std::int64_t end, AfterBeat after_beat) {
    bool is_running = false;
    for (; !is_asleep_until(end) && goes_on(); is_running = true) {
      const bool is_overrun = is_running && begun() >= k;
      const std::int64_t beat = is_overrun ? begun() + 1 : k;
      if (is_overrun) {
        add(own().overruns, 1);
        if constexpr (Traceable<D>)
          if (auto* const track = state.trace.get()) track->overrun(beat - k);
      }
      if (beat >= end) return lose_until(end);
      if (!wait_for_beat(beat, after_beat)) return;
      lose_until(newest_due(begun()));
      run_timed_beat();
      announce();
      if (!after_beat()) stop();
    }
  }

  // No environment begins a further beat.
  void stop() { own().stop_at.store(k, std::memory_order_release); }

  // ---- at the end of a run ----

  static constexpr bool idles = any_component<graph, call_on_idle>;
  static constexpr bool has_hooks_of_resources = idles || any_component<graph, call_on_fault>;

  // Instead of a beat, while others have not ended.
  void idle() noexcept {
    handle_fault();
    if constexpr (idles) visit_components<graph>(call_on_idle{}, state);
  }
  // Its beats are over: who sleeps looks whether the run goes on.
  void tell_end() noexcept { shared().ends.ring(); }
  // When its last beat began, or when it idled last.
  std::int64_t last_active() const noexcept { return active_at; }

  // Goes on with beat `next`: those in between count as done, also where a fault has cut the last.
  void skip_to(std::int64_t next) {
    for (std::int64_t skipped = std::max<std::int64_t>(k - 1, 0); skipped < next; ++skipped) {
      repeat_outputs<graph>(state, skipped);
      state.repeat_leaving(skipped);
      if (state.is_exact) repeat_firings(skipped);
    }
    if (next > k) tell_skipped(k, next - k);
    k = done = next;
    tell_reached();
  }

  // To a recorder, if this environment has the first node of a part.
  void tell_part([[maybe_unused]] int part,
                 [[maybe_unused]] bool stops,
                 [[maybe_unused]] bool requested,
                 [[maybe_unused]] std::int64_t from) noexcept {
    if constexpr (Recordable<D>)
      if (plan_of<D>.nodes[array_size(first_node_of_part<D>(part))].environment == E)
        if (auto* const tap = state.tap.get()) tap->part_changed(part, stops, requested, from);
  }

  // At the end of a run: what was asked for in the beats before `beat`, and no more.
  void settle_parts(std::int64_t beat) {
    take_part_requests(beat);
    state.requests.forget(shared());
  }

  // Once, in the beat of a fault: instead of what would still have come.
  void handle_fault() noexcept {
    if (shared().fault_position() == no_position || has_handled_fault) return;
    has_handled_fault = true;
    visit_components<graph>(call_on_fault{}, state);
  }

private:
  exchange<D>& shared() { return *state.shared; }
  auto& own() { return shared().environments[E]; }
  std::int64_t position(int rank = 0) const { return exchange<D>::position_of(k, rank); }
  void announce() {
    tell_reached();
    state.announce(position());
  }
  std::int64_t begun() { return shared().environments[0].begun.load(std::memory_order_acquire); }
  bool goes_on() { return shared().fault_position() == no_position && shared().stop_at() == no_position; }
  CCA_INLINE void state_fault(loop_observers to, int rank, std::string_view reason, int node) noexcept {
    own().fault.state(position(rank), reason, node);
    state.tell_fault(to, reason.data(), node, k);
  }
  template <class Pace>
  cca::fault wait(run_record& runs, Pace& pace, std::int64_t time) {
    if constexpr (Traceable<D>) return runs.wait(pace, time, state.trace.get());
    else return runs.wait(pace, time);
  }

  // Of a recordable deployment: either beat is a function of its own, so that neither pays for the other.
  void run_beat() noexcept
    requires(Recordable<graph>)
  {
    if (state.is_observed()) run_observed();
    else run_unseen();
  }
  [[gnu::flatten]] void run_beat() noexcept
    requires(!Recordable<graph>)
  {
    run_beat_of<graph>();
  }
  [[gnu::noinline, gnu::flatten]] void run_unseen() noexcept { run_beat_of<graph>(); }
  [[gnu::noinline, gnu::flatten]] void run_observed() noexcept { run_beat_of<probed<graph>>(); }

  template <class Key>
  CCA_INLINE void run_beat_of() noexcept {
    const loop_observers observers = observers_in<Key>(state);
    if (!state.is_exact)
      if (const int lost = state.count_late(k, observers); lost >= 0)
        return state_fault(observers, 0, lost_contact<D>(lost), -1);
    if constexpr (is_probed<Key>) state.begin_frame(k);
    if (auto* const track = trace_of<Key>(state)) [[unlikely]]
      track->begin(k);
    state.receive(state, k);
    take_part_requests(k);
    if (auto* const track = trace_of<Key>(state)) [[unlikely]]
      track->pass();
    beat_outcome outcome;
    if (begins<Key>(state, outcome, k)) beat_of_graph<Key>::run(state, outcome, k);
    if (auto* const track = trace_of<Key>(state)) [[unlikely]]
      track->end();
    if constexpr (is_probed<Key>) state.end_frame();
    if constexpr (asks_for_parts<D>(E))
      if (state.is_asked) [[unlikely]] {
        if (outcome.fault || state.is_cut) forget_requests(state);
        else send_requests<D, E>(shared(), state, k, state.is_exact);
      }
    if constexpr (counts_of<graph>.may_fault)
      if (outcome.fault) state_fault(observers, state.fault_rank, outcome.fault, outcome.node);
    done = ++k;
  }

  void run_timed_beat() noexcept {
    const std::int64_t begins = active_at = monotonic_clock::now();
    const std::int64_t beat = k;
    own().slowest.begin(beat, begins);
    const auto& first = shared().environments[0];
    own().wake_up.add(begins - first.begun_at[first.slot_of(beat)].load(std::memory_order_relaxed));
    run_beat();
    const std::int64_t needed = monotonic_clock::now() - begins;
    own().duration.add(needed);
    own().slowest.end(beat, needed);
  }

  // Skips the beats in which nothing can fire. True: there is no other before the end.
  bool is_asleep_until(std::int64_t end) {
    if (const std::int64_t next = std::min(next_active_beat<D, E>(k), end); next > k) {
      k = next;
      announce();
    }
    return k == end;
  }

  // A function whose clock is known in the whole architecture counts as fired in a beat that was cut, as in
  // one loop, also where its clock is not known in this part.
  void repeat_firings([[maybe_unused]] std::int64_t beat) {
    if constexpr (layout_of<graph>.firing_count > 0)
      for (std::size_t c = 0; c < array_size(counts_of<D>.call_count); ++c)
        if (const int at = layout_of<graph>.calls[c].firing;
            at >= 0 && is_started(plan_of<D>.calls[c], beat) && ticks(plan_of<D>.calls[c].own_clock, beat)) {
          state.firings[at].last = beat;
          state.firings[at].is_first = false;
        }
  }

  bool is_started([[maybe_unused]] const call& c, [[maybe_unused]] std::int64_t beat) const {
    if constexpr (parts_kept<graph> > 0) {
      const int part = plan_of<D>.nodes[array_size(c.node)].part;
      return part < 0 ||
             (!state.parts[array_size(part)].rests && state.parts[array_size(part)].since <= beat);
    }
    return true;
  }
  // Before beat `next`.
  void take_part_requests(std::int64_t next) noexcept {
    state.requests.take(shared(), state, next, [this](int number, bool stops, std::int64_t from) {
      tell_part(number, stops, true, from);
    });
  }

  // False: a fault or the end has come before it.
  bool wait_until_it_may_begin() noexcept {
    for (learned_patience patience = state.be_patient();; patience.wait()) {
      const bool may_begin = state.may_begin(k);
      if (shared().fault_position() < position() || shared().stop_at() <= k) return false;
      if (may_begin) return true;
      if (patience.is_time_to_ask()) state.look_for_missing(k, position() - 1);
    }
  }

  // Waits until all others have done the beats before k. False: one of them faulted or stopped.
  bool all_have_come() noexcept {
    for (learned_patience patience = state.be_patient(); goes_on(); patience.wait()) {
      if (state.all_have_come_to(position())) return true;
      if (patience.is_time_to_ask()) state.look_for_those_before(position());
    }
    return false;
  }

  void tell_reached() noexcept {
    if constexpr (Recordable<D>)
      if (auto* const tap = state.tap.get()) tap->reach(k);
  }
  void tell_skipped([[maybe_unused]] std::int64_t first, [[maybe_unused]] std::int64_t count) noexcept {
    if constexpr (Recordable<D>)
      if (auto* const tap = state.tap.get()) tap->skipped(first, count, !state.is_exact);
  }

  void lose_until(std::int64_t next) {
    // Beats in which samples only enter queues are none that are lost: they enter in the next one.
    if (const std::int64_t fires = std::min(next_firing_beat<D, E>(k), next); fires > k) k = fires;
    add(own().lost_periods, next - k);
    if (next > k) skip_to(next);
  }

  // The newest beat up to `now`, and from k on, in which something can fire.
  std::int64_t newest_due(std::int64_t now) const {
    std::int64_t newest = k;
    for (std::int64_t next = k; (next = next_firing_beat<D, E>(next + 1)) <= now;) newest = next;
    return newest;
  }

  bool has_handled_fault = false;
  std::int64_t active_at = 0;
};

}  // namespace cca::detail
