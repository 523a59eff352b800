// A deployment in this process: each environment is a loop in a thread of its own, the first in the thread
// that calls `run`. It does what `controller` does, bit for bit, for any placement.
//
//   cca::deployed<split> d;
//   d.load(); d.start(); d.run(cca::for_<10>{}, cca::at_wall_clock());
//
// As fast as possible, `between` sees all environments at rest after each beat. At wall-clock speed it runs
// between two beats of the first environment, while the others go on: then it may touch components of the
// first, and nothing of the others but the counts. Errors: deployment.*. Example: docs/environments.md.
#pragma once

#include <array>
#include <atomic>
#include <iostream>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <cca/runtime/component_host.hpp>
#include <cca/runtime/environments/environment_threads.hpp>
#include <cca/runtime/environments/figures.hpp>
#include <cca/runtime/refusal.hpp>
#include <cca/runtime/run_record.hpp>

namespace cca {
namespace detail {

struct nothing_between {
  template <class Deployed>
  constexpr void operator()(Deployed&) const {}
};

}  // namespace detail

// Of a deployment that breaks a rule: one error, which is the message.
template <class D>
class deployed : public controller<D> {
  static_assert(Deployment<D> || !well_formed<D>,
                "cca::deployed: its argument is no deployment: give it a struct derived from "
                "cca::deployment<Architecture, cca::environment<...>, ...>, or run the graph by "
                "cca::controller<Graph>");

public:
  std::int64_t late() const noexcept { return 0; }
};

template <class D>
  requires Deployment<D> && well_formed<D>
class deployed<D> : public detail::component_host<deployed<D>, D> {
  using host = detail::component_host<deployed<D>, D>;
  friend host;

public:
  using host::period;

  deployed() : shared(std::make_unique<detail::exchange<D>>()) {}

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
  cca::state run(Duration duration, Pace pace = {}, Between&& between = {}) {
    move(detail::transition::run, "run()");
    {
      const detail::end_of_run at_the_end{now};
      run_all(duration.beats(period()), pace, between);
    }
    return now;
  }

  // In the runs at wall-clock speed since start(). Beats whose samples had not come when they began, each
  // environment that was late counted; beats that were still running when the next should begin; the periods
  // in which no beat began. Sums over all environments. These and `figures` may be called from any thread
  // while it runs.
  std::int64_t late() const noexcept {
    std::int64_t all = 0;
    for (const auto& e : shared->environments)
      for (const auto& channel : e.late) all += channel.load(std::memory_order_relaxed);
    return all;
  }
  std::int64_t overruns() const noexcept {
    std::int64_t all = 0;
    for (const auto& e : shared->environments) all += e.overruns.load(std::memory_order_relaxed);
    return all;
  }
  std::int64_t lost_periods() const noexcept {
    std::int64_t all = 0;
    for (const auto& e : shared->environments) all += e.lost_periods.load(std::memory_order_relaxed);
    return all;
  }
  std::vector<environment_figures> figures() const {
    std::vector<environment_figures> all;
    for (std::size_t e = 0; e < shared->environments.size(); ++e) {
      const auto& record = shared->environments[e];
      auto& one = all.emplace_back(environment_figures{
          name_of(e), record.wake_up, record.beat, record.overruns, record.lost_periods, {}});
      for (std::size_t from = 0; from < record.late.size(); ++from)
        if (detail::crossings_of<D>.least_delay[from][e] > 0)
          one.channels.push_back({name_of(from), record.late[from]});
    }
    return all;
  }

  // The next beat.
  std::int64_t beat_index() const noexcept { return k; }

  // As of a controller.
  template <class F>
  void observed(F f) const {
    [&]<int... Output>(std::integer_sequence<int, Output...>) {
      const int all[] = {0, (observe<Output>(f), 0)...};
      (void)all;
    }(detail::chosen<detail::counts_of<D>.output_count, detail::is_watched<D>>{});
  }

private:
  template <int Node>
  static constexpr int environment_of = detail::plan_of<D>.nodes[Node].environment;

  template <int Node>
  auto& component() {
    return component_of<Node>(*this);
  }
  template <int Node>
  const auto& component() const {
    return component_of<Node>(*this);
  }
  template <int Node, class Deployed>
  static auto& component_of(Deployed& self) {
    constexpr int e = environment_of<Node>;
    return detail::component_at<detail::part<D, e>, Node>(self.loops.template at<e>().state);
  }
  // f(number, component) for each, in declaration order.
  template <class F, class Deployed>
  static void visit(F f, Deployed& self) {
    [&]<int... Node>(std::integer_sequence<int, Node...>) {
      const int all[] = {0, (f(Node, component_of<Node>(self)), 0)...};
      (void)all;
    }(std::make_integer_sequence<int, detail::counts_of<D>.node_count>{});
  }

  template <int Output, class F>
  void observe(F& f) const {
    constexpr int e = environment_of<detail::call_of<D, detail::output_of<D, Output>.call>.node>;
    detail::observe_newest<detail::part<D, e>, Output>(loops.template at<e>().state, k, f);
  }

  void forget_runs() {
    runs.overruns = runs.lost_periods = 0;
    for (auto& e : shared->environments) e.forget();
  }
  static constexpr std::string_view name_of(std::size_t environment) {
    return detail::environments_of<D>::all[environment].name;
  }

  // What the system refused to the thread of an environment.
  template <int E>
  void report(const std::string& refusal) {
    if (refusal.empty()) return;
    const std::string text =
        "cca::deployed: environment `" + std::string(name_of(E)) + "` does not run in real time: " + refusal;
    if (detail::wish_of_environment<D, E>.is_needed) throw refused(text);
    if (!is_told[E]) std::cerr << text << '\n';
    is_told[E] = true;
  }

  template <class Pace, class Between>
  void run_all(std::int64_t beats, Pace& pace, Between& between) {
    constexpr bool is_exact = !detail::OnClock<Pace>;
    constexpr bool is_watched = !std::is_same_v<std::remove_cv_t<Between>, detail::nothing_between>;
    constexpr bool all_meet = is_exact && (is_watched || !std::is_same_v<Pace, as_fast_as_possible>);
    const std::int64_t end = beats > detail::no_position - k ? detail::no_position : k + beats;
    std::int64_t last_seen = k;
    auto& first = loops.template at<0>();
    const auto after_beat = [&] {
      last_seen = k = first.k;
      return detail::goes_on_after(between, *this);
    };
    const detail::thread_setup setup(detail::wish_of_environment<D, 0>);
    report<0>(setup.refusal());
    prepare(is_exact, all_meet ? 0 : detail::most_ahead);
    runs.begin(pace, period());
    {
      const finished_run all_at_one_beat{*this, is_exact};
      const detail::environment_threads<D> others(
          loops, *shared, end, is_exact,
          [this]<int E>(const std::string& refusal) { this->template report<E>(refusal); });
      if constexpr (is_exact) first.lead_exactly(end, runs, pace, after_beat);
      else first.lead(end, runs, pace, after_beat);
      first.handle_fault();
    }
    if (now == cca::state::faulted && last_seen < k) detail::goes_on_after(between, *this);
  }

  void prepare(bool is_exact, std::int64_t ahead) {
    shared->should_stop = false;
    shared->fault.forget();
    loops.for_each([&]<int E>(auto& loop) { loop.prepare(*shared, is_exact, ahead, k); });
  }

  struct finished_run {
    deployed& all;
    bool is_exact;
    ~finished_run() { all.finish(is_exact); }
  };
  // All environments continue with the same beat.
  void finish(bool is_exact) {
    const std::int64_t fault_at = shared->fault.position;
    loops.for_each([&]<int E>(auto& loop) {
      loop.handle_fault();
      k = std::max(k, loop.k);
    });
    const bool is_faulted = fault_at != detail::no_position;
    if (is_exact && is_faulted) k = fault_at / detail::exchange<D>::calls_and_one + 1;
    loops.for_each([&]<int E>(auto& loop) { loop.skip_to(k); });
    if (!is_faulted) return;
    reason = {shared->fault.reason, shared->fault.node};
    now = detail::after(detail::transition::fail, now);
  }

  [[gnu::noinline]] void idle() {
    visit(
        []<class C>(int, C& component) {
          if constexpr (detail::IsResource<C> && detail::OnIdle<C>) component.on_idle();
        },
        *this);
  }

  using host::move, host::now, host::reason;

  detail::environment_loops<D> loops;
  std::unique_ptr<detail::exchange<D>> shared;
  std::int64_t k = 0;
  detail::run_record runs{};
  std::array<bool, detail::array_size(detail::environment_count<D>)> is_told{};
};

}  // namespace cca
