// What a controller of one loop does: single beats, runs, and what it counts of them. `Self` is the
// controller; besides what component_host.hpp asks of it, it has
//
//   advance()   the next beat
#pragma once

#include <cstdint>

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
  cca::state run(Duration duration, Pace pace = {}, Between&& between = [](Self&) {}) {
    this->move(transition::run, "run()");
    {
      const end_of_run at_the_end{now};
      const std::int64_t beats = duration.beats(period());
      runs.begin(pace, period());
      std::int64_t paced_from = 0;
      for (std::int64_t i = 0; i < beats && now == cca::state::running; ++i) {
        if (const cca::fault late = wait(pace, (i - paced_from) * period())) fail({late.reason(), -1});
        else self().advance();
        if (!goes_on_after(between, self())) break;
        if constexpr (Controls<Between, Self>)
          if (!listen(pace, between, [&] { paced_from = i + 1; })) break;
      }
    }
    if (now == cca::state::started) this->tell_state();
    tell_end(between, self());
    return now;
  }

  // In the wall-clock runs since start(): the beats that were still running when the next should
  // begin, and the periods in which no beat began.
  std::int64_t overruns() const noexcept { return runs.overruns; }
  std::int64_t lost_periods() const noexcept { return runs.lost_periods; }

  // The next beat.
  std::int64_t beat_index() const noexcept { return k; }

protected:
  // In the beat of the fault, instead of what would still have come.
  [[gnu::noinline]] void fail(beat_outcome outcome) noexcept {
    reason = outcome;
    Self::visit(call_on_fault{}, self());
    now = after(transition::fail, now);
    if constexpr (requires(Self& s) { s.recorded_into(); })
      if (auto* const tap = self().recorded_into()) {
        tap->failed(outcome.node, outcome.fault, outcome.node < 0 ? k : k - 1);
        tap->moved(now, k);
      }
    if constexpr (requires(Self& s) { s.traced_into(); })
      if (auto* const track = self().traced_into()) {
        track->failed(outcome.node, outcome.fault);
        track->moved(now);
      }
  }
  void forget_runs() { runs.overruns = runs.lost_periods = 0; }

  using host::now, host::reason;
  std::int64_t k = 0;

private:
  Self& self() { return static_cast<Self&>(*this); }

  // What others want, also while the next beat is far off. False: the run ends. `begun_anew()`: the pace
  // counts from the next beat on.
  template <class Pace, class Between, class F>
  bool listen(Pace& pace, Between& between, F begun_anew) {
    bool is_single = false;  // a single beat is made, whatever is wanted next
    while (now == cca::state::running) {
      if (between.control().has_news() && !is_single) [[unlikely]] {
        if (!obey(pace, between)) return false;
        begun_anew();
        is_single = between.control().is_paused();
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

  template <class Pace>
  cca::fault wait(Pace& pace, std::int64_t time) {
    if constexpr (requires(Self& s) { s.traced_into(); }) return runs.wait(pace, time, self().traced_into());
    else return runs.wait(pace, time);
  }

  run_record runs{};
};

}  // namespace cca::detail
