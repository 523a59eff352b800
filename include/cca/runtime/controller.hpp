// The controller of a graph: all its components, folded into one loop. It is a value: a copy is a snapshot.
//
//   cca::controller<trot<cca::sim::oncilla>> c;
//   c.load(); c.start(); c.run(cca::for_<10>{});
//
// Outside of the loop, what can't be done is refused by `cca::refused` with a message. In the loop nothing
// throws, allocates or locks. So no other thread may call anything here, `get`, `set` and `observed`
// included, while a beat runs: call them between two beats, in the thread that runs them.
#pragma once

#include <cca/graph/marks/recordable.hpp>
#include <cca/graph/marks/traceable.hpp>
#include <cca/runtime/cut_beat.hpp>
#include <cca/runtime/loop_host.hpp>
#include <cca/runtime/observers/loop_observers.hpp>
#include <cca/runtime/one_beat.hpp>
#include <cca/runtime/refusal.hpp>

namespace cca {
namespace detail {
struct live_components;
}

template <detail::WellFormed Graph>
class controller<Graph> : public detail::loop_host<controller<Graph>, Graph> {
  using host = detail::loop_host<controller<Graph>, Graph>;

public:
  // Calls f(observation) for each output that an `observe` among the items of a graph names, with its newest
  // sample; fresh: published in the last beat.
  template <class F>
  void observed(F f) const {
    detail::observe_all<Graph>(state_of_all, k, f);
  }
  // The same, and of a queue it takes what it has shown.
  template <class F>
  void observed(F f) {
    detail::observe_all<Graph>(state_of_all, k, f);
    detail::take_outside<Graph>(state_of_all);
  }
  // The newest samples, whatever the policies: for cca::live_access.
  template <class F>
  void observed_newest(F f) const {
    detail::observe_newest_of<Graph>(state_of_all, k, f);
  }

private:
  friend detail::component_host<controller, Graph>;
  friend host;
  friend detail::live_components;
  friend detail::stoppable_parts<controller, Graph>;
  friend detail::dropped_samples<controller, Graph>;

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
  static void for_each_part_state(int, F f, Controller& self) {
    f.template operator()<Graph>(self.state_of_all, self.k);
  }
  static constexpr bool is_here(int) { return true; }
  template <class F>
  void for_each_state(F f) const {
    f.template operator()<Graph>(state_of_all);
  }

  // Of a recordable graph: either beat is a function of its own, so that neither pays for the other.
  void advance() noexcept
    requires(detail::Recordable<Graph>)
  {
    if constexpr (detail::is_always_probed<Graph>) advance_replayed();
    else if (state_of_all.is_observed()) advance_observed();
    else advance_unseen();
  }
  CCA_BEAT void advance() noexcept
    requires(!detail::Recordable<Graph>)
  {
    run_beat<Graph>();
  }
  [[gnu::noinline]] CCA_BEAT void advance_unseen() noexcept { run_beat<Graph>(); }
  [[gnu::noinline]] CCA_BEAT void advance_observed() noexcept { run_beat<detail::probed<Graph>>(); }
  [[gnu::noinline]] CCA_REPLAYED_BEAT void advance_replayed() noexcept { run_beat<detail::probed<Graph>>(); }

  template <class Key>
  CCA_INLINE void run_beat() noexcept {
    detail::beat_outcome outcome;
    const std::int64_t beat = k;
    const auto frame = detail::begin_observed<Key>(state_of_all, beat);
    detail::run_beat_of_graph<Key>(state_of_all, outcome, beat, frame);
    detail::end_observed<Key>(state_of_all, frame);
    end_beat(outcome);
  }
  CCA_INLINE void end_beat([[maybe_unused]] const detail::beat_outcome& outcome) noexcept {
    ++k;
    if constexpr (detail::counts_of<Graph>.may_fault)
      if (outcome.fault) {
        detail::repeat_outputs<Graph>(state_of_all, k - 1);
        detail::note_missed<Graph>(state_of_all, k - 1, outcome.turns);
        if constexpr (has_requests) detail::forget_requests(state_of_all);
        host::fail(outcome);
      }
    if constexpr (has_requests)
      if (state_of_all.is_asked) [[unlikely]]
        take_requests();
  }
  static constexpr bool has_requests = detail::counts_of<Graph>.request_count > 0;
  [[gnu::noinline]] void take_requests() noexcept {
    detail::take_requests<Graph>(state_of_all, k, [this](int part, bool stops) {
      this->observers().part_changed(part, stops, true, k);
    });
  }

  using host::k;

  detail::kept_state<Graph> state_of_all;
};

}  // namespace cca
