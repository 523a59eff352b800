// The loop of one environment: its components, which beats it runs, and when.
//
// A fast run waits for every sample that it needs, so that all is as in one loop. A wall-clock run never
// waits for a sample: the first environment gives the beat, the others follow it. A free-running one
// then follows nobody: its cycles begin without pause.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <cca/base/separate/function_ref.hpp>
#include <cca/runtime/each_component.hpp>
#include <cca/runtime/environments/loop/active_beats.hpp>
#include <cca/runtime/environments/loop/cycles.hpp>
#include <cca/runtime/environments/links/links.hpp>
#include <cca/runtime/environments/waiting/lost_contact.hpp>
#include <cca/runtime/environments/loop/mode_of_loop.hpp>
#include <cca/runtime/environments/loop/asked_of_loop.hpp>
#include <cca/runtime/environments/loop/repeat_firings.hpp>
#include <cca/runtime/environments/waiting/beats_of_first.hpp>
#include <cca/runtime/environments/waiting/beats_of_others.hpp>
#include <cca/runtime/cut_beat.hpp>
#include <cca/runtime/one_beat.hpp>
#include <cca/runtime/run_record.hpp>

namespace cca::detail {

template <class D, int E>
class alignas(64) environment_loop : beats_of_first<environment_loop<D, E>, D>,
                                     beats_of_others<environment_loop<D, E>>,
                                     public cycles_of<environment_loop<D, E>, D, E>,
                                     admission_of<environment_loop<D, E>, D, E>,
                                     public asked_of_loop<environment_loop<D, E>, D, E>,
                                     public mode_of_loop<environment_loop<D, E>, D, E> {
  using graph = loop_key<D, E>;
  using first_beats = beats_of_first<environment_loop, D>;
  friend first_beats;
  friend cycles_of<environment_loop, D, E>;
  friend admission_of<environment_loop, D, E>;
  friend asked_of_loop<environment_loop, D, E>;
  friend mode_of_loop<environment_loop, D, E>;
  friend agreed_changes<D, E>;
  friend beats_of_others<environment_loop>;
  using first_beats::wait_for_beat, first_beats::wait_for_last_beat;
  using asked = asked_of_loop<environment_loop, D, E>;
  using asked::tell_reached, asked::tell_skipped;
  static constexpr std::int64_t period = counts_of<D>.period;
  static constexpr bool is_free = is_free_running<D, E>;

public:
  using cycles_of<environment_loop, D, E>::index, cycles_of<environment_loop, D, E>::next_beat;

  std::int64_t k = 0;     // the next beat; asleep, the next in which something can fire
  std::int64_t done = 0;  // after the last beat that has run
  loop_state<D, E> state;

  // Before a run, while all environments rest. `ahead`: of the others, in a fast run.
  void prepare(
      exchange<D>& exchanged, const peers* others, bool is_exact, std::int64_t ahead, std::int64_t beat) {
    state.shared = &exchanged;
    state.others = others;
    state.rings = others ? others->rings() : nullptr;
    state.courier = is_exact && others && others->works_in_environment() ? others : nullptr;
    if constexpr (is_free) skip_to(beat);  // as after the run before
    state.is_exact = is_exact;
    state.ahead = ahead;
    state.is_cut = false;
    state.forget_others();
    state.changes.forget(exchanged);
    has_handled_fault = false;
    if constexpr (!is_free) skip_to(beat);
    this->in_mode([&]<class Part>() { this->template links_in<Part>().begin_queues(beat); });
    own().begun = beat - 1;
    own().begun_at[0] = own().begun_at[1] = own().interval = 0;
    own().slowest.forget();
    own().fault.position = no_position;
    own().stop_at = no_position;
    own().is_paused = false;
    announce();
    if (E == 0 && ahead == 0) state.move_to(position() - 1);  // when its pace lets it begin
    if (has_free_running<D>) state.observers().runs_freely(k, !is_exact);
    if constexpr (is_free) exchanged.template results<E>().begin_run();
    this->begin_admission();
  }

  // `after_beat`, of the first environment in each process, returns false at the end.

  // ---- in a fast run ----

  // Where no environment may be ahead, `after_beat` sees all environments at rest.
  template <class Pace, class AfterBeat, class Obey>
  void lead_exactly(std::int64_t end, run_record& runs, Pace& pace, AfterBeat after_beat, Obey obey) {
    std::int64_t first = k;
    while (k < end && this->wait_until_it_may_begin([]() noexcept {})) {
      runs.wait(pace, (k - first) * period, state.observers());
      if (state.ahead == 0) announce();
      run_beat();
      if (state.ahead > 0) announce();
      else if (this->all_have_come() && !after_beat()) stop();
      if (state.ahead == 0 && obey.has_news()) [[unlikely]] {
        this->hold(obey);
        first = k;
      }
    }
  }

  // `meanwhile`: between two beats, too, while it waits for others.
  template <class AfterBeat, class Meanwhile>
  void follow_exactly(std::int64_t end, AfterBeat after_beat, Meanwhile meanwhile) {
    while (!is_asleep_until(end) && this->wait_until_it_may_begin(meanwhile)) {
      run_beat();
      if (state.ahead == 0 && !after_beat()) stop();
      announce();
    }
  }

  // ---- in a wall-clock run ----

  // obey.has_news(): somebody wants a pause, or another speed. obey(idle, goes_on): does it; false: the run
  // ends.
  template <class Pace, class AfterBeat, class Obey>
  void lead(std::int64_t end, run_record& runs, Pace& pace, AfterBeat after_beat, Obey obey) {
    std::int64_t first = k;
    while (k < end && goes_on()) {  // a beat that a fault has cut is no overrun
      const cca::fault late = runs.wait(pace, (k - first) * period, state.observers());
      own().overruns.store(runs.overruns, std::memory_order_relaxed);
      own().lost_periods.store(runs.lost_periods, std::memory_order_relaxed);
      if (late) state_fault(state.observers(), 0, late.reason(), -1);
      if (!goes_on()) return;
      own().begun_at[own().slot_of(k)].store(pace.last_begun(), std::memory_order_relaxed);
      own().interval.store(pace.duration_of(period), std::memory_order_relaxed);
      if (!this->admit()) return;
      own().begun.store(k, std::memory_order_release);
      state.ring();
      run_timed_beat();
      announce();
      this->look_for_free(end);
      if (!after_beat()) stop();
      for (bool is_single = false;;) {  // a single beat is made, whatever is wanted next
        if (!obey.looks_until_it_is_near(is_single, [this] { return goes_on(); })) stop();
        if (is_single || !obey.has_news()) break;
        this->hold(obey);
        first = k;
        is_single = obey.holds_pause();
      }
    }
  }

  // A beat that is still running when the next should begin is an overrun; the next begins with the first
  // environment's next beat. It is the newest that is due: those in between are lost. `meanwhile`, if it is
  // one: a few times a second and more while it waits for a beat, also where none is left for it.
  template <class AfterBeat>
  void follow(std::int64_t end, AfterBeat after_beat, function_ref<void()> meanwhile) {
    if constexpr (is_free) return this->run_freely(end, after_beat, meanwhile);
    bool is_running = false;
    for (; !is_asleep_until(end) && goes_on(); is_running = true) {
      const bool is_overrun = is_running && begun() >= k;
      const std::int64_t beat = is_overrun ? begun() + 1 : k;
      if (is_overrun) {
        add(own().overruns, 1);
        state.observers().overrun(beat - k);
      }
      if (beat >= end) return lose_until(end);
      if (!wait_for_beat(beat, after_beat, meanwhile)) return;
      lose_until(newest_due(begun()));
      run_timed_beat();
      announce();
      if (!after_beat()) stop();
    }
    // With resource nodes it idles until all have ended.
    if (meanwhile && !has_hooks_of_resources) this->wait_for_last_beat(end, meanwhile);
  }

  // No environment begins a further beat.
  void stop() { own().stop_at.store(k, std::memory_order_release); }

  // What another thread changes now comes before this beat. Asleep, that is not the next one that it runs.
  std::int64_t beat_of_change() const {
    if (is_free || state.is_exact || !state.shared) return next_beat();
    return std::min(k, begun() + 1);
  }

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
    if constexpr (is_free)
      if (!state.is_exact) return this->end_cycles(next);
    for (std::int64_t skipped = std::max<std::int64_t>(k - 1, this->first_of_mode()); skipped < next;
         ++skipped)
      this->in_mode([&]<class Part>() {
        repeat_outputs<Part>(state, index() + skipped - k);
        if (skipped >= k) note_missed<Part>(state, index() + skipped - k, 0);
        this->template links_in<Part>().repeat_leaving(skipped);
        if (state.is_exact)
          repeat_by_whole<deployment_of_part<Part>, E>(state, skipped, index() + skipped - k);
      });
    this->skip_indices(next);
    if (next > k) tell_skipped(k, next - k, !state.is_exact);
    k = done = next;
    tell_reached();
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
  std::int64_t begun() const { return state.shared->environments[0].begun.load(std::memory_order_acquire); }
  bool goes_on() { return shared().fault_position() == no_position && shared().stop_at() == no_position; }
  CCA_INLINE void state_fault(loop_observers to, int rank, std::string_view reason, int node) noexcept {
    std::int64_t beat = k;
    if constexpr (is_free) beat = state.beat;
    own().fault.state(exchange<D>::position_of(beat, rank), reason, node);
    // A cycle of a wall-clock run began in some beat; the fault comes before the next one.
    const char* const literal = reason.data();
    to.failed(node, literal, next_beat());
  }

  // Of a recordable deployment: either beat is a function of its own, so that neither pays for the other.
  void run_beat() noexcept
    requires(DeploymentOfModes<D>)
  {
    this->run_beat_of_mode();
  }
  void run_beat() noexcept
    requires(Recordable<graph> && !DeploymentOfModes<D>)
  {
    if (state.is_observed()) run_observed();
    else run_unseen();
  }
  CCA_BEAT void run_beat() noexcept
    requires(!Recordable<graph> && !DeploymentOfModes<D>)
  {
    run_beat_of<graph>();
  }
  [[gnu::noinline]] CCA_BEAT void run_unseen() noexcept { run_beat_of<graph>(); }
  [[gnu::noinline]] CCA_BEAT void run_observed() noexcept { run_beat_of<probed<graph>>(); }

  template <class Key>
  CCA_INLINE void run_beat_of() noexcept {
    using mode = typename as_planned<Key>::type;
    const loop_observers observers = observers_in<Key>(state);
    const std::int64_t beat = this->beat_that_begins();
    auto& links = this->template links_in<mode>();
    if (!DeploymentOfModes<D> && !state.is_exact)
      if (const int lost = state.count_late(k, observers); lost >= 0)
        return state_fault(observers, 0, lost_contact<D>(lost), -1);
    const auto frame = begin_observed<Key>(state, beat, this->template first_trace_name<mode>());
    if constexpr (is_probed<Key>) this->tell_arrivals(frame.frame);
    this->begin_cycle(beat);
    links.receive(state, beat);
    if constexpr (!DeploymentOfModes<D>) this->take_changes(beat);
    if (auto* const track = trace_of<Key>(state)) [[unlikely]]
      track->pass();
    beat_outcome outcome;
    run_beat_of_graph<Key>(state, outcome, index(), frame);
    end_observed<Key>(state, frame, !is_free || state.is_exact);
    if constexpr (asks_for_changes<D>(E))
      if (this->is_asked()) [[unlikely]] {
        if (outcome.fault || state.is_cut) this->forget_asked();
        else this->send_asked(beat);
      }
    if (outcome.turns != all_turns) [[unlikely]]
      note_missed<mode>(state, index(), outcome.turns);
    if constexpr (counts_of<mode>.may_fault)
      if (outcome.fault)
        state_fault(observers, state.fault_rank, outcome.fault, this->template node_of<mode>(outcome.node));
    if constexpr (is_free) {
      ++state.index;
      if (!state.is_exact) return shared().template results<E>().end_cycle();
    }
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

  // Skips the beats in which nothing can fire, unless all meet after each. True: there is no other.
  bool is_asleep_until(std::int64_t end) {
    if (state.is_exact && state.ahead == 0) return k == end;
    if (const std::int64_t next = std::min(next_active_beat<D, E>(k), end); next > k) {
      k = next;
      announce();
    }
    return k == end;
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
