// What is published elsewhere without delay enters the queues of an environment before the first call that
// must find it there: the reader, or one that publishes into the same queue. `Links` is environment_links.
//
// A queue that may reject what enters holds up the calls behind the one that published it, in all
// environments, until that has gone well.
#pragma once

#include <cstdint>
#include <utility>

#include <cca/runtime/environments/links/fault_order.hpp>
#include <cca/runtime/environments/links/ways_from_elsewhere.hpp>

namespace cca::detail {

template <class Links, class D, int E, class Queues = queues_entered_at_once<D, E>>
class entries_in_beat;
template <class Links, class D, int E, int... Queue>
class entries_in_beat<Links, D, E, std::integer_sequence<int, Queue...>> {
public:
  // Beat k was cut: what was published in it all the same, elsewhere, enters the queues.
  void settle_queues([[maybe_unused]] std::int64_t k) noexcept {
    [[maybe_unused]] beat_outcome unread;
    if (links().is_exact) (enter<Queue, counts_of<D>.call_count>(unread, k), ...);
  }

protected:
  // Before the call of this rank waits for others: one after another in the order of the whole. False: the
  // beat ends here.
  template <int Rank>
  CCA_INLINE bool enter_what_may_be_rejected([[maybe_unused]] beat_outcome& outcome,
                                             [[maybe_unused]] std::int64_t k) noexcept {
    if constexpr (sizeof...(Queue) == 0) return true;
    else
      return [&]<int... Writer>(std::integer_sequence<int, Writer...>) {
        return (enter_rejecting<Writer>(outcome, k) && ...);
      }(chosen<counts_of<D>.call_count, enters_before<Rank>>{});
  }
  // Then. False: a queue was full that rejects it.
  template <int Rank>
  CCA_INLINE bool enter_before([[maybe_unused]] beat_outcome& outcome,
                               [[maybe_unused]] std::int64_t k) noexcept {
    if constexpr ((is_entered_at<Rank, Queue>() || ...)) {
      if (enters_in_beat() && !links().is_cut)
        ((is_entered_at<Rank, Queue>() ? enter<Queue, order.rank_in_plan[Rank]>(outcome, k) : void()), ...);
      if (outcome.fault) links().fault_rank = order.whole_rank[array_size(Rank)];
      return !outcome.fault;
    }
    return true;
  }

private:
  static constexpr const auto& order = fault_order_of<D, E>;
  Links& links() noexcept { return static_cast<Links&>(*this); }

  // In a wall-clock run a cycle begins with all that has come.
  bool enters_in_beat() noexcept { return links().is_exact || !is_free_running<D, E>; }

  // The call reads the queue, or publishes into it.
  template <int Rank, int Input>
  static constexpr bool is_entered_at() {
    const auto& plan = plan_of<D>;
    const flat_view g = plan.view();
    const int here = order.rank_in_plan[Rank], call = g.order[here];
    if (g.inputs[Input].call == call) return true;
    bool found = false;
    for_each_way(g, Input, [&](const input& way) {
      const int from = g.outputs[way.writer].call;
      found |= crosses_at_once(g, way) && g.calls[from].rank < here && shares_queue(g, from, call);
    });
    return found;
  }
  template <int Input, int RankInPlan>
  void enter(beat_outcome& outcome, std::int64_t k) noexcept {
    enter_at_once<D, E, Input, RankInPlan>(static_cast<controller_state<part<D, E>>&>(links()), outcome, k);
  }

  template <int Rank>
  struct enters_before {
    static constexpr bool holds(std::size_t r) { return order.enters_before[r] == Rank; }
  };
  template <int Writer>
  bool enter_rejecting(beat_outcome& outcome, std::int64_t k) noexcept {
    constexpr int from = [] {
      const auto& plan = plan_of<D>;
      return environment_of(plan.view(), plan.order[array_size(Writer)]);
    }();
    constexpr int rank = rejecting_entries<D> + Writer;
    if (links().is_exact) links().template wait_until<from>(links().beat_at(k), rank + 1, rank);
    if (links().is_cut) return false;
    if (!enters_in_beat()) return true;
    (enter<Queue, Writer + 1>(outcome, k), ...);
    if (outcome.fault) return links().fault_rank = rank, false;
    links().move_to(exchange<D>::position_of(links().beat_at(k), rank + 1));
    return true;
  }
};

}  // namespace cca::detail
