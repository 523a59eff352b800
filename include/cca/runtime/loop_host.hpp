// What a controller of one loop does: single beats, runs, and what it counts of them. `Self` is the
// controller; besides what component_host.hpp asks of it, it has
//
//   advance()   the next beat
#pragma once

#include <concepts>
#include <cstdint>
#include <cstdlib>

#include <cca/runtime/component_host.hpp>
#include <cca/runtime/pace.hpp>
#include <cca/runtime/run_record.hpp>

namespace cca::detail {

template <class Self, class Graph>
class loop_host : public component_host<Self, Graph> {
  using host = component_host<Self, Graph>;

public:
  using host::period;

  // One beat. False where the life-cycle does not allow it: before start(), after stop() and after a fault.
  // Then only the hook `on_idle` of resource nodes runs: a robot goes on stopping.
  bool step() noexcept {
    const bool may_run = is_legal(transition::run, now);
    if (may_run) self().advance();
    else if constexpr (any_component<Graph, call_on_idle>) this->idle();
    return may_run;
  }

  // Beats for a time, at a pace, and between them a call of yours: between(controller). Ends at once on a
  // fault, and where `between` returns false. Whatever ends it, an exception too, it is then `started` or
  // `faulted`.
  template <class Duration, class Pace = as_fast_as_possible, class Between = void (*)(Self&)>
    requires RunArguments<Duration, Pace>
  cca::state run(Duration duration, Pace pace = {}, Between&& between = [](Self&) {}) {
    this->move(transition::run, "run()");
    {
      const end_of_run at_the_end{now};
      const std::int64_t beats = duration.beats(period());
      runs.begin(pace, period());
      std::int64_t paced_from = 0;
      for (std::int64_t i = 0; i < beats && now == cca::state::running; ++i) {
        if (const cca::fault late = runs.wait(pace, (i - paced_from) * period(), this->observers()))
          fail({late.reason(), -1});
        else self().advance();
        if (!goes_on_after(between, self())) break;
        if constexpr (Controls<Between, Self>)
          if (!listen(pace, between, [&] { paced_from = i + 1; })) break;
      }
      if constexpr (requires { between.after_last_beat(self()); }) between.after_last_beat(self());
    }
    if (now == cca::state::started) this->tell_state();
    tell_end(between, self());
    return now;
  }
  template <class... Arguments>
    requires(!RunArguments<Arguments...>)
  cca::state run(Arguments&&...) {
    return refuse_run<Arguments...>();
  }

  // A copy that can go on, also from within a run: in `between`, say, to look ahead. It is `started` where
  // this one is running; so to go back within a run, assign a plain copy: a snapshot would end the run.
  Self snapshot() const {
    static_assert(
        std::copy_constructible<Self>,
        "cca::controller: snapshot() copies the controller, and one of its components can't be copied");
    if constexpr (std::copy_constructible<Self>) {
      Self copy(self());
      if (now == cca::state::running) copy.now = after(transition::pause, now);
      return copy;
    } else {
      std::abort();
    }
  }

  // In the wall-clock runs since start(): the beats that were still running when the next should
  // begin, and the periods in which no beat began.
  std::int64_t overruns() const noexcept { return runs.overruns; }
  std::int64_t lost_periods() const noexcept { return runs.lost_periods; }

  // The next beat.
  std::int64_t beat_index() const noexcept { return k; }

  // For the recorder of a recordable graph: called in each beat; null if nothing is recorded.
  void record_into(beat_tap<Graph>* tap) noexcept
    requires(Recordable<Graph>)
  {
    self().state_of_all.tap.set(tap);
    parameters_changed();
  }
  beat_tap<Graph>* recorded_into() const noexcept
    requires(Recordable<Graph>)
  {
    return self().state_of_all.tap.get();
  }
  // For the tracer of a traceable graph: f(number of the loop, the place of its observer).
  template <class F>
  void for_each_trace(F f) noexcept
    requires(Traceable<Graph>)
  {
    f(0, self().state_of_all.trace);
  }
  trace_track* traced_into() const noexcept
    requires(Traceable<Graph>)
  {
    return self().state_of_all.trace.get();
  }
  // Tells a recorder that parameters were changed by other ways than `set` and `load`.
  void parameters_changed() noexcept {
    if constexpr (Recordable<Graph>)
      if (auto* const tap = recorded_into()) tap->parameters_changed(self().state_of_all, k);
  }

protected:
  // In the beat of the fault, instead of what would still have come.
  [[gnu::noinline]] void fail(beat_outcome outcome) noexcept {
    reason = outcome;
    Self::visit(call_on_fault{}, self());
    now = after(transition::fail, now);
    const loop_observers told = this->observers();
    told.failed(outcome.node, outcome.fault, outcome.node < 0 ? k : k - 1);
    told.moved(now, k);
  }
  void forget_runs() { runs.overruns = runs.lost_periods = 0; }

  using host::now, host::reason;
  std::int64_t k = 0;

private:
  Self& self() { return static_cast<Self&>(*this); }
  const Self& self() const { return static_cast<const Self&>(*this); }

  // What others want, also while the next beat is far off. False: the run ends. `begun_anew()`: the pace
  // counts from the next beat on.
  template <class Pace, class Between, class F>
  bool listen(Pace& pace, Between& between, F begun_anew) {
    bool is_single = false;  // a single beat is made, whatever is wanted next
    while (now == cca::state::running) {
      if (between.control().has_news() && !is_single) [[unlikely]] {
        if (!obey(pace, between)) return false;
        begun_anew();
        is_single = between.control().holds_pause();
      } else if (!dozes(pace, period())) {
        break;
      } else if (!between.while_paused(self())) {
        return false;
      }
    }
    return true;
  }
  // False: the run ends. After a pause nothing is caught up.
  template <class Pace, class Between>
  [[gnu::noinline]] bool obey(Pace& pace, Between& between) {
    const auto idle = [&] {
      if constexpr (any_component<Graph, call_on_idle>) this->idle();
    };
    const auto goes_on = [&] { return now == cca::state::running && between.while_paused(self()); };
    if (!between.control().obey(pace, period(), idle, goes_on)) return false;
    runs.begin(pace, period());
    return true;
  }

  run_record runs{};
};

}  // namespace cca::detail
