// The controller of a graph: all its components, folded into one loop. It is a value: a copy is a snapshot.
//
//   cca::controller<trot<cca::sim::oncilla>> c;
//   c.load(); c.start(); c.run(cca::for_<10>{});
//
// Outside of the loop, what can't be done is refused by `cca::refused` with a message. In the loop nothing
// throws, allocates or locks. So no other thread may call anything here, `get`, `set` and `observed`
// included, while a beat runs: call them between two beats, in the thread that runs them.
#pragma once

#include <cca/runtime/component_host.hpp>
#include <cca/runtime/cut_beat.hpp>
#include <cca/runtime/one_beat.hpp>
#include <cca/runtime/pace.hpp>
#include <cca/runtime/refusal.hpp>
#include <cca/runtime/run_record.hpp>

namespace cca {
namespace detail {
struct live_components;
}

template <class Graph>
  requires well_formed<Graph>
class controller<Graph> : public detail::component_host<controller<Graph>, Graph> {
  using host = detail::component_host<controller<Graph>, Graph>;

public:
  using host::period;

  // One beat. False where the life-cycle does not allow it: before start(), after stop() and after a fault.
  // Then only the hook `on_idle` of resource nodes runs: a robot goes on stopping.
  bool step() noexcept {
    const bool may_run = detail::is_legal(detail::transition::run, now);
    if (may_run) advance();
    else if constexpr (detail::any_component<Graph, detail::call_on_idle>) idle();
    return may_run;
  }

  // Beats for a time, at a pace, and between them a call of yours: between(*this). Ends at once on a fault,
  // and where `between` returns false. Whatever ends it, an exception too, it is then `started` or `faulted`.
  template <class Duration, class Pace = as_fast_as_possible, class Between = void (*)(controller&)>
  cca::state run(Duration duration, Pace pace = {}, Between&& between = [](controller&) {}) {
    move(detail::transition::run, "run()");
    {
      const detail::end_of_run at_the_end{now};
      const std::int64_t beats = duration.beats(period());
      runs.begin(pace, period());
      for (std::int64_t i = 0; i < beats && now == cca::state::running; ++i) {
        if (const cca::fault late = runs.wait(pace, i * period())) fail({late.reason(), -1});
        else advance();
        if (!detail::goes_on_after(between, *this)) break;
      }
    }
    return now;
  }

  // In the runs at wall-clock speed since start(): the beats that were still running when the next should
  // begin, and the periods in which no beat began.
  std::int64_t overruns() const noexcept { return runs.overruns; }
  std::int64_t lost_periods() const noexcept { return runs.lost_periods; }

  // The next beat.
  std::int64_t beat_index() const noexcept { return k; }

  // Calls f(observation) for each output that an `observe` among the items of a graph names, with its newest
  // sample; fresh: published in the last beat.
  template <class F>
  void observed(F f) const {
    [&]<int... Output>(std::integer_sequence<int, Output...>) {
      const int all[] = {0, (detail::observe_newest<Graph, Output>(state_of_all, k, f), 0)...};
      (void)all;
    }(detail::chosen<detail::counts_of<Graph>.output_count, detail::is_watched<Graph>>{});
  }

private:
  friend detail::component_host<controller, Graph>;
  friend detail::live_components;
  friend detail::stoppable_components<controller, Graph>;

  template <int Node>
  auto& component() {
    return detail::component_at<Graph, Node>(state_of_all);
  }
  template <int Node>
  const auto& component() const {
    return detail::component_at<Graph, Node>(state_of_all);
  }
  template <class F, class Controller>
  static void visit(F f, Controller& self) {
    detail::visit_components<Graph>(f, self.state_of_all);
  }
  template <class F, class Controller>
  static void visit_firings(int node, F f, Controller& self) {
    detail::visit_firings<Graph>(self.state_of_all, node, f);
  }
  static constexpr bool is_here(int) { return true; }
  void forget_runs() { runs.overruns = runs.lost_periods = 0; }

  [[gnu::flatten]] void advance() noexcept {
    detail::beat_outcome beat_outcome;
    detail::beat_of_graph<Graph>::run(state_of_all, beat_outcome, k);
    ++k;
    if constexpr (detail::counts_of<Graph>.may_fault)
      if (beat_outcome.fault) {
        detail::repeat_outputs<Graph>(state_of_all, k - 1);
        fail(beat_outcome);
      }
  }

  // In the beat of the fault, instead of what would still have come.
  [[gnu::noinline]] void fail(const detail::beat_outcome& beat_outcome) noexcept {
    reason = beat_outcome;
    visit(detail::call_on_fault{}, *this);
    now = detail::after(detail::transition::fail, now);
  }

  using host::idle, host::move, host::now, host::reason;

  detail::controller_state<Graph> state_of_all;
  std::int64_t k = 0;
  detail::run_record runs{};
};

}  // namespace cca
