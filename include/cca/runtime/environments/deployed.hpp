// A deployment in this process: each environment is a loop in a thread of its own, the first in the thread
// that calls `run`. It does what `controller` does, bit for bit, for any placement.
//
//   cca::deployed<split> d;
//   d.load(); d.start(); d.run(cca::for_<10>{}, cca::at_wall_clock());
//
// In a fast run, `between` sees all environments at rest after each beat. In a wall-clock run it runs
// between two beats of the first environment, while the others go on: then it may touch components of the
// first, and nothing of the others but the counts.
//
// Threads: late(), overruns(), lost_periods() and figures() may be called by any thread at any time. All
// other member functions, those of the bases too (get, set, parameter, load, save, start, stop, resume,
// state, fault), are for one thread at a time: between two runs any thread, while it runs the thread that
// called `run`, in `between`, as far as said above. cca::live_access gives other threads the rest. Errors:
// deployment.*. Example: docs/environments.md.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/runtime/component_host.hpp>
#include <cca/runtime/environments/environment_threads.hpp>
#include <cca/runtime/environments/figures_of_runs.hpp>
#include <cca/runtime/environments/meeting.hpp>
#include <cca/runtime/environments/mode_of_deployed.hpp>
#include <cca/runtime/environments/ordered_changes.hpp>
#include <cca/runtime/environments/only.hpp>
#include <cca/runtime/environments/placed_components.hpp>
#include <cca/runtime/refusal.hpp>
#include <cca/runtime/run_record.hpp>
#include <cca/runtime/environments/transport.hpp>
#include <cca/runtime/environments/waiting/obeyed_control.hpp>

namespace cca {

// A deployment that breaks a rule gives one error, which is the message.
template <class D>
class deployed : public controller<D> {
  static_assert(
      detail::holds_or_tells<(AnyDeployment<D> || !well_formed<D>), detail::no_deployment<D>>::value);

public:
  template <class... Arguments>
  deployed(const Arguments&...) {}
  std::int64_t late() const noexcept { return 0; }
};

template <class D>
  requires AnyDeployment<D> && well_formed<D>
class deployed<D> : public detail::component_host<deployed<D>, D>,
                    public detail::figures_of_runs<deployed<D>, D>,
                    public detail::mode_of_deployed<deployed<D>, D>,
                    detail::ordered_changes<deployed<D>, D>,
                    detail::told_environments<D> {
  using host = detail::component_host<deployed<D>, D>;
  using placed = detail::placed_components<D>;
  using told = detail::told_environments<D>;
  using own_mode = detail::mode_of_deployed<deployed<D>, D>;
  using changes = detail::ordered_changes<deployed<D>, D>;
  friend host;
  friend placed;
  friend detail::live_components;
  friend detail::stoppable_parts<deployed<D>, D>;
  friend detail::dropped_samples<deployed<D>, D>;
  friend detail::figures_of_runs<deployed<D>, D>;
  friend own_mode;
  friend changes;

public:
  using host::period;  // any thread, at any time

  // ---- one thread at a time, between two runs ----

  // All environments in this process.
  deployed() : shared(std::make_shared<detail::exchange<D>>()) {
    here.fill(true);
    own_mode::choose_teller();
  }

  // Some of them; other processes run the rest. `transport`: cca::shared_memory. Refused: an environment that
  // the deployment doesn't have, or that another process runs, and a process of another deployment.
  template <class T = detail::no_argument>
  deployed(const only& environments, const T& transport = {}) {
    here = detail::chosen_environments<D>(environments);
    static_assert(detail::holds_or_tells<Transport<T, D>, detail::no_transport<D, T>>::value);
    if constexpr (Transport<T, D>) {
      auto medium = transport.template open<D>(here);
      shared = {medium, medium->exchanged()};
      others = std::move(medium);
    }
    own_mode::choose_teller();
  }
  deployed(deployed&&) = default;  // between two runs
  deployed& operator=(deployed&&) = default;

  // One beat of all environments; false where the life-cycle does not allow it. Then only the hook `on_idle`
  // of resource nodes runs. It starts and ends the threads: for many beats use `run`.
  bool step() {
    const bool may_run = detail::is_legal(detail::transition::run, now);
    if (may_run) run(for_beats<1>{});
    else idle();
    return may_run;
  }

  // Beats for a time, at a pace. Ends at once on a fault, and where `between` returns false. Whatever ends
  // it, all environments have done the same number of beats then.
  template <class Duration, class Pace = as_fast_as_possible, class Between = detail::nothing_between>
    requires detail::RunArguments<Duration, Pace>
  cca::state run(Duration duration, Pace pace = {}, Between&& between = {}) {
    move(detail::transition::run, "run()");
    bool is_stopped_elsewhere = false;
    {
      const detail::end_of_run at_the_end{now};
      is_stopped_elsewhere = !run_all(duration.beats(period()), pace, between);
    }
    if (is_stopped_elsewhere) stop();
    else this->tell_state();
    detail::tell_end(between, *this);
    return now;
  }
  template <class... Arguments>
    requires(!detail::RunArguments<Arguments...>)
  cca::state run(Arguments&&...) {
    return detail::refuse_run<Arguments...>();
  }

  // One component, by its path: also while it runs, in the thread of the environment that runs it, between
  // two of its beats: in `between` one of the first environment, or, in a fast run, any.
  using host::start, host::stop;

  // As of a controller. Where other processes run environments, their run ends with stop() too.
  void start() {
    const typename own_mode::hooks_of_active_mode now_on(*this);
    host::start();
    changes::forget_wishes();
    tell_stopped(0);
  }
  void stop() {
    const typename own_mode::hooks_of_active_mode now_on(*this);
    host::stop();
    tell_stopped(++stops_called);
  }

  // The next beat. While it runs: in `between`.
  std::int64_t beat_index() const noexcept { return k; }

  // As of a controller. While it runs: in `between`, in a fast run.
  template <class F>
  void observed(F f) const {
    placed::observe_here(k, f);
  }
  template <class F>
  void observed(F f) {
    placed::observe_and_take_here(k, f);
  }

  // As of a controller, and of its environments in this process.
  using told::for_each_trace, told::traced_into, told::for_each_tap, told::recorded_into;
  using told::parameters_changed_in;

  // As of a controller. In a wall-clock run: those of the first environment, which `between` may touch.
  void parameters_changed() noexcept { told::parameters_changed(now == cca::state::running, first_here()); }

private:
  void check_part(const char* call, int part) const { own_mode::check_part_of_mode(call, part); }
  bool is_here(int node) const { return placed::is_here(node) && own_mode::has_hooks(node); }

  void tell_part([[maybe_unused]] int part, [[maybe_unused]] bool stops) {
    loops.for_each([&]<int E>(auto& loop) {
      if (here[E]) loop.tell_part(part, stops, false, next_beat_of(E));
    });
  }
  void forget_runs() {
    runs.overruns = runs.lost_periods = 0;
    for (std::size_t e = 0; e < here.size(); ++e)
      if (here[e]) shared->environments[e].forget_figures();
  }
  void tell_stopped(std::int64_t number) {
    for (std::size_t e = 0; e < here.size(); ++e)
      if (here[e]) shared->environments[e].stopped.store(number, std::memory_order_release);
  }

  // False: another process has stopped, and there is no run.
  template <class Pace, class Between>
  bool run_all(std::int64_t beats, Pace& pace, Between& between) {
    constexpr bool is_watched = !std::is_same_v<std::remove_cv_t<Between>, detail::nothing_between>;
    const bool wants_exact = !detail::OnClock<Pace>;
    const bool wants_to_meet = is_watched || !std::is_same_v<Pace, as_fast_as_possible>;
    // From here on, until all have ended, this thread is that of its environment.
    const detail::scheduling_of_caller before;
    std::optional<detail::thread_setup> setup;
    loops.for_each([&]<int E>(auto&) {
      if (E != first_here()) return;
      setup.emplace(detail::wish_of_environment<D, E>);
      refusals.template report<E>(setup->refusal());
    });
    detail::meeting<D> together(*shared, here, others.get());
    auto idle_beats = detail::idle_beats_at(pace, period());
    const auto meanwhile = [this] { idle(); };
    detail::terms_of_run wanted{k, 0, wants_exact, wants_to_meet};
    wanted.stops = stops_called;
    own_mode::tell_mode(wanted);
    changes::tell_wishes();
    const auto terms = together.agree(wanted, beats, longest_wait, idle_beats, meanwhile,
                                      [&] { return !detail::wants_end(between); });
    if (terms.is_stopped) return false;
    if (terms.is_off) return true;
    stops_called = 0;
    if (terms.is_exact && !wants_exact) idle_beats = detail::idle_beats_at(as_fast_as_possible(), period());
    if (!terms.is_exact && wants_exact) idle_beats = detail::idle_beats_at(at_wall_clock(), period());
    std::int64_t last_seen = k = terms.beat;
    loops.for_each([&]<int E>(auto& loop) {
      if (here[E])
        loop.prepare(*shared, others.get(), terms.is_exact, terms.all_meet ? 0 : detail::most_ahead<D>,
                     terms.beat);
    });
    own_mode::join_mode(terms);
    changes::obey_wishes();
    together.begin(terms.beat, longest_wait, idle_beats, meanwhile);
    {
      const detail::at_the_end all_at_one_beat{[&] { finish(together, terms, idle_beats); }};
      changes::begin_run(terms.is_exact);
      loops.for_each([&]<int E>(auto& first) {
        if (E != first_here()) return;
        const auto after_beat = [&] {
          last_seen = k = first.next_beat();
          take_changes_at_rest();
          look_after(E, between);
          return detail::goes_on_after(between, *this);
        };
        run_environments<E>(first, terms, pace, between, after_beat, idle_beats, before);
      });
    }
    for (int e = 0; e < detail::environment_count<D>; ++e)
      if (here[detail::array_size(e)]) look_after(e, between);
    if (now == cca::state::faulted && last_seen < k) detail::goes_on_after(between, *this);
    return true;
  }

  // In the thread of an environment, after its beat: what looks at each of them (cca::live_access).
  template <class Between>
  void look_after([[maybe_unused]] int environment, [[maybe_unused]] Between& between) {
    if constexpr (detail::LooksAfterEach<Between, deployed>)
      loops.for_each([&]<int E>(auto& loop) {
        if (E != environment) return;
        looked_at[E] = loop.beat_of_change();
        between.template after_beat<E>(*this);
        looked_at[E] = 0;
      });
  }

  // `first` in this thread, the others in threads of their own.
  template <int E, class Loop, class Pace, class Between, class AfterBeat>
  void run_environments(Loop& first,
                        const detail::terms_of_run& terms,
                        Pace& pace,
                        Between& between,
                        AfterBeat after_beat,
                        detail::idle_beats& idle_beats,
                        const detail::scheduling_of_caller& before) {
    const auto look = [this, &between](int environment) { look_after(environment, between); };
    detail::function_ref<void(int)> after_beat_of_others;
    if constexpr (detail::LooksAfterEach<Between, deployed>) after_beat_of_others = look;
    const detail::environment_threads<D> followers(
        loops, E, here, terms, idle_beats, before, refusals, [this] { idle(); }, after_beat_of_others);
    if constexpr (E > 0) {
      const detail::asked_after_beat asked{after_beat};
      const auto look_here = [&look] { look(E); };
      detail::function_ref<void()> meanwhile;
      if constexpr (detail::LooksAfterEach<Between, deployed>) meanwhile = look_here;
      if (terms.is_exact) first.follow_exactly(terms.end, asked, look_here);
      else first.follow(terms.end, asked, meanwhile);
    } else {
      runs.begin(pace, period());
      const detail::obeyed_control<deployed, Pace, Between> obey{*this, runs, pace, between};
      if constexpr (detail::OnClock<Pace>) first.lead(terms.end, runs, pace, after_beat, obey);
      else first.lead_exactly(terms.end, runs, pace, after_beat, obey);
    }
  }

  // All environments continue with the same beat.
  void finish(detail::meeting<D>& together,
              const detail::terms_of_run& terms,
              detail::idle_beats& idle_beats) {
    loops.for_each([&]<int E>(auto& loop) {
      if (here[E]) k = std::max(k, loop.done);
    });
    k = together.end(k, idle_beats, [this] {
      loops.for_each([&]<int E>(auto& loop) {
        if (here[E]) loop.idle();
      });
    });
    const auto& first = shared->first_to_fail();
    changes::end_run();
    const std::int64_t fault_at = first.fault.position;
    const bool is_faulted = fault_at != detail::no_position;
    if (terms.is_exact && is_faulted) k = fault_at / detail::exchange<D>::calls_and_one + 1;
    loops.for_each([&]<int E>(auto& loop) {
      if (!here[E]) return;
      loop.handle_fault();
      loop.settle_changes(is_faulted ? k - 1 : k, k, !is_faulted);
      if (is_faulted) loop.settle_queues(k - 1);
      loop.skip_to(k);
    });
    if (!is_faulted) return;
    reason = {first.fault.reason.data(), first.fault.node};
    this->keep_cause(first, first_here());
    now = detail::after(detail::transition::fail, now);
  }

  using changes::next_beat_of, changes::first_here, changes::is_at_rest, changes::is_ordered,
      changes::take_changes_at_rest, changes::next_of_first_here, changes::needs_order, changes::order,
      changes::order_at_rest, changes::set_part_in, changes::is_computing;
  using host::idle, host::move, host::now, host::reason;
  using placed::component, placed::component_of, placed::visit, placed::for_each_part_state,
      placed::for_each_state, placed::loops, placed::here;
  using placed::refuse_if_elsewhere, placed::refuse_elsewhere, placed::observed_in, placed::observed_newest,
      placed::observed_in_any_mode, placed::next_of;

  static constexpr std::int64_t longest_wait = 10'000'000'000;  // for environments of other processes, ns

  std::shared_ptr<const detail::peers> others;  // null: all are here
  std::shared_ptr<detail::exchange<D>> shared;
  std::int64_t k = 0, stops_called = 0;  // the next beat; stops since the last run
  std::array<std::int64_t, detail::array_size(detail::environment_count<D>)> looked_at{};  // 0: not now
  detail::run_record runs{};
  detail::real_time_refusals<D> refusals{};
};

}  // namespace cca
