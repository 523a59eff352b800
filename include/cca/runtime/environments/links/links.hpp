// How the parts of a deployment hang together: an environment sends what it publishes, takes what others have
// published, and knows how far they are.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <cca/runtime/environments/exchange/exchange.hpp>
#include <cca/runtime/environments/links/fault_order.hpp>
#include <cca/runtime/environments/waiting/lost_contact.hpp>
#include <cca/runtime/environments/links/links_of_environment.hpp>
#include <cca/runtime/environments/waiting/patience.hpp>
#include <cca/runtime/environments/exchange/peers.hpp>
#include <cca/runtime/environments/links/entries_in_beat.hpp>
#include <cca/runtime/environments/links/receive_samples.hpp>
#include <cca/runtime/observers/loop_observers.hpp>

namespace cca::detail {

template <class D,
          int E,
          class Others = std::make_integer_sequence<int, environment_count<D>>,
          class Arriving = chosen<counts_of<D>.output_count, arrives<part<D, E>>>,
          class Entering = ways_from_elsewhere<part<D, E>>>
class environment_links;

template <class D, int E, int... Other, int... Arriving, int... Way>
class environment_links<D,
                        E,
                        std::integer_sequence<int, Other...>,
                        std::integer_sequence<int, Arriving...>,
                        std::integer_sequence<int, Way...>>
    : public base_of_links<D, E>::type,
      public ways_of<environment_links<D, E>, D, E>,
      public entries_in_beat<environment_links<D, E>, D, E> {
  friend entries_in_beat<environment_links, D, E>;
  static constexpr bool is_free = is_free_running<D, E>;
  using shared_by_all = whole_of<D>;
  using base = typename base_of_links<D, E>::type;

public:
  using base::shared, base::others, base::is_exact, base::ahead, base::is_cut, base::rings, base::courier,
      base::habit, base::fault_rank;
  // Of this mode.
  using ways_of<environment_links, D, E>::begin_queues;
  using entries_in_beat<environment_links, D, E>::settle_queues,
      entries_in_beat<environment_links, D, E>::enter_what_may_be_rejected,
      entries_in_beat<environment_links, D, E>::enter_before;

  // A component publishes in beat k.
  template <int Output, class Vector>
  CCA_INLINE void send(const Vector& v, std::int64_t origin, std::int64_t k) {
    if constexpr (is_free)
      if (!is_exact)
        return shared->template results<E>().template put<shared_output_of<D, Output>>(v, origin, this->beat);
    shared->template put<shared_output_of<D, Output>>(v, origin, beat_at(k), is_exact);
  }

  // When beat k begins: takes what was published before it, into the samples that the components read.
  template <class State>
  void receive([[maybe_unused]] State& state, [[maybe_unused]] std::int64_t k) noexcept {
    (receive_one<Arriving>(state, k, k), ...);
    if constexpr (has_parts) this->received = k + 1;
  }

  // Beat k was cut or skipped: what should have left by a known clock leaves again.
  void repeat_leaving(std::int64_t k) noexcept {
    [&]<int... Output>(std::integer_sequence<int, Output...>) {
      const int repeated[] = {0, (repeat_one<Output>(k), 0)...};
      (void)repeated;
    }(chosen<counts_of<D>.output_count, leaves_by_clock<D, E>>{});
  }

  // An environment whose process has ended sends nothing more: that is a fault here. `has_come()` is asked
  // once more afterwards, when the counters of that environment are final.
  template <class F>
  void look_for(int environment, std::int64_t position, F has_come) noexcept {
    if (others && others->is_gone(environment) && !has_come()) {
      shared->environments[E].fault.state(position, lost_contact<shared_by_all>(environment), -1);
      observers().failed(-1, lost_contact<shared_by_all>(environment).data(),
                         position / exchange<shared_by_all>::calls_and_one);
    }
  }
  // Between two beats.
  loop_observers observers() const noexcept {
    using loop = loop_key<shared_by_all, E>;
    return observers_in<std::conditional_t<Recordable<D>, probed<loop>, loop>>(
        static_cast<const loop_state<shared_by_all, E>&>(*this));
  }
  // Looks for the environments that beat k still waits for.
  void look_for_missing(std::int64_t k, std::int64_t position) noexcept {
    (look_for(Other, position, [&] { return is_far_enough<Other>(k); }), ...);
  }

  // This environment is there; those that wait for it look again.
  void move_to(std::int64_t position) noexcept {
    shared->move_to(E, position);
    ring();
  }
  void ring() noexcept {
    if (!rings) return;
    rings->leaving.ring();
    rings->arriving.ring();
  }
  // When a beat is done.
  void announce(std::int64_t position) noexcept {
    shared->move_to(E, position);
    if (courier) courier->send();
    else ring();
  }
  learned_patience be_patient() noexcept {
    return learned_patience(habit, rings ? &rings->arriving : nullptr, courier);
  }

  // Whether all others are at a position, and whether those that are not will come.
  bool all_have_come_to(std::int64_t position) noexcept {
    return ((Other == E || has_come_to<Other>(position)) && ...);
  }
  void look_for_those_before(std::int64_t position) noexcept {
    (look_for(Other, position - 1, [&] { return Other == E || has_come_to<Other>(position); }), ...);
  }

  // In a fast run: whether beat k may begin. All samples for it are here, and nobody is so far behind
  // that a sample is lost, or might still fault in the beat before.
  bool may_begin(std::int64_t k) noexcept { return (is_far_enough<Other>(k) && ...); }

  // When beat k begins in a wall-clock run: counts the environments whose samples should be here and are not.
  // The one that has been late for more beats in a row than is tolerated; -1: none.
  int count_late(std::int64_t k, loop_observers to) noexcept {
    int lost = -1;
    (count_late_from<Other>(k, lost, to), ...);
    return lost;
  }
  // Of a run before.
  void forget_others() noexcept {
    this->seen.fill(-1);
    this->late_in_a_row = {};
  }

  // Nothing has gone wrong elsewhere before this call. False: the beat ends here.
  template <int Rank>
  CCA_INLINE bool is_due(std::int64_t k,
                         [[maybe_unused]] beat_outcome& outcome,
                         [[maybe_unused]] trace_track* track) noexcept {
    if (!this->template enter_what_may_be_rejected<Rank>(outcome, k)) return false;
    if constexpr (((needed<Other>(Rank) > (Rank == 0 ? 0 : needed<Other>(Rank - 1))) || ...))
      if (is_exact) {
        (wait_for<Other>(beat_at(k), Rank), ...);
        if (track) [[unlikely]]
          track->waited();
      }
    if constexpr ((is_taken_at<Rank, Arriving>() || ...))
      if (is_exact && !is_cut) (take_at_once<Rank, Arriving>(beat_at(k)), ...);
    if (!this->template enter_before<Rank>(outcome, k)) return false;
    if constexpr (((needed<Other>(Rank) > 0) || ...)) return !is_cut;
    else return true;
  }
  // The call of this rank went well; others may wait for it.
  template <int Rank>
  CCA_INLINE bool is_done(std::int64_t k) noexcept {
    constexpr auto others_wait = [] {
      const auto& plan = plan_of<part<D, E>>;
      const auto& whole = plan_of<D>;
      const int call = plan.order[array_size(Rank)];
      return std::pair(may_fault_in(plan.view(), plan.calls[array_size(call)]),
                       is_call_read_at_once(whole.view(), call));
    }();
    const std::int64_t done =
        exchange<shared_by_all>::position_of(beat_at(k), order.whole_rank[array_size(Rank)] + 1);
    if constexpr (others_wait.second) announce(done);
    else if constexpr (others_wait.first) move_to(done);
    return true;
  }
  template <int Rank>
  CCA_INLINE bool is_faulted() noexcept {
    return fault_rank = order.whole_rank[array_size(Rank)], false;
  }
  // What arrived when beat k began has entered the queues. `outcome`: one was full and rejects it.
  CCA_INLINE bool have_entered([[maybe_unused]] std::int64_t k,
                               [[maybe_unused]] const beat_outcome& outcome,
                               [[maybe_unused]] int input) noexcept {
    if constexpr (order.own_entries > 0) {
      if (outcome.fault) fault_rank = order.rank_of_entries[array_size(input)];
      else move_to(exchange<shared_by_all>::position_of(k, order.own_entries));
    }
    return !outcome.fault;
  }

private:
  static constexpr const auto& order = fault_order_of<D, E>;
  // The loop must know when a sample came, whether it looked then or not.
  static constexpr bool has_parts = parts_kept<part<D, E>> > 0 || DeployedMode<D>;

  // The beat that the loop of this part has as `k`.
  CCA_INLINE std::int64_t beat_at(std::int64_t k) const noexcept {
    if constexpr (is_free) return this->beat;
    else return k;
  }
  CCA_INLINE std::int64_t index_at(std::int64_t k) const noexcept {
    if constexpr (is_free) return this->index;
    else return k;
  }
  template <int Rank, int Output>
  static constexpr bool is_taken_at() {
    const auto& plan = plan_of<part<D, E>>;
    return reads_at_once(plan.view(), plan.order[array_size(Rank)], Output);
  }
  template <int Rank, int Output>
  CCA_INLINE void take_at_once(std::int64_t k) noexcept {
    if constexpr (is_taken_at<Rank, Output>())
      receive_one<Output>(static_cast<controller_state<part<D, E>>&>(*this), k, k + 1);
  }

  template <int X>
  static constexpr int needed(int rank) {
    return order.needed[X][array_size(rank)];
  }
  template <int Output>
  static constexpr int environment_of_output = [] {
    const auto& plan = plan_of<D>;
    return environment_of(plan.view(), plan.outputs[Output].call);
  }();
  static constexpr int least_delay(int from, int to) {
    return crossings_of<shared_by_all>.least_delay[array_size(from)][array_size(to)];
  }

  template <int Output, class State>
  void receive_one(State& state, std::int64_t k, std::int64_t end) noexcept {
    constexpr bool is_index = is_free || !has_parts;
    const std::int64_t came = is_index ? index_at(k) : is_exact ? arrives_when_published : this->received;
    receive_samples<D, E, Output>(state, next_of<Output>(), k, end, came);
  }

  template <int Output>
  void repeat_one(std::int64_t k) noexcept {
    constexpr int output = shared_output_of<D, Output>;
    if (!ticks(published_of<D, Output>, k)) return;
    if constexpr (DeployedMode<D>)
      shared->template ring<output>().repeat(k, this->came_in[array_size(output)]);
    else shared->template ring<output>().repeat(k);
  }

  // In a fast run it looks again only where the last look does not tell: each look fetches the number
  // from another core. In a wall-clock run a peer that is refused goes back.
  template <int X>
  bool has_come_to(std::int64_t position) noexcept {
    std::int64_t& last = this->seen[X];
    if (!is_exact || last < position) last = shared->position(X);
    return last >= position;
  }
  template <int X>
  bool has_done(std::int64_t beats) noexcept {
    return has_come_to<X>(exchange<shared_by_all>::position_of(beats));
  }

  template <int X, int Output, class Next>
  bool is_here(std::int64_t k, const Next& next) const noexcept {
    if constexpr (environment_of_output<Output> != X) return true;
    const std::int64_t due = newest_tick(published_of<D, Output>, k);
    return next.newest >= due || shared->template ring<shared_output_of<D, Output>>().has(next.number, due);
  }
  // All samples of X up to beat k.
  template <int X>
  bool are_here(std::int64_t k) noexcept {
    if constexpr (samples_tell<D, X, Arriving..., input_of<part<D, E>, Way>.writer...>)
      if ((is_here<X, Arriving>(k, next_of<Arriving>()) && ...) &&
          (is_here<X, input_of<part<D, E>, Way>.writer>(k, static_cast<const next_by_way<D, Way>&>(*this)) &&
           ...))
        return true;
    return has_done<X>(k + 1);
  }

  template <int X>
  bool is_far_enough(std::int64_t k) noexcept {
    if constexpr (X == E) return true;
    if constexpr (least_delay(X, E) > 0)
      if (!are_here<X>(k - least_delay(X, E))) return false;
    if constexpr (least_delay(E, X) > 0 || X == 0)
      if (!(ahead > 0 && samples_show_progress<D, X, E>) && !has_done<X>(k - ahead)) return false;
    if constexpr (obeys_orders<shared_by_all, E>)
      if (ahead == 0 && !has_done<X>(k)) return false;
    if constexpr (DeployedMode<D>) return !may_fault_in_some_mode<shared_by_all, X> || has_done<X>(k);
    else
      return order.last[X] == 0 || has_come_to<X>(exchange<shared_by_all>::position_of(k - 1, order.last[X]));
  }
  template <int X>
  void wait_for(std::int64_t k, int rank) noexcept {
    if (needed<X>(rank) > 0) wait_until<X>(k, needed<X>(rank), order.whole_rank[array_size(rank)]);
  }
  // Until the call before `done` is over, for one of this rank.
  template <int X>
  void wait_until(std::int64_t k, int done, int rank) noexcept {
    const auto from = exchange<shared_by_all>::position_of(k, done);
    const auto here = exchange<shared_by_all>::position_of(k, rank);
    for (learned_patience patience = be_patient(); !is_cut; patience.wait()) {
      const bool is_there = shared->position(X) >= from;
      is_cut = shared->fault_position() <= here || shared->stop_at() <= k;
      if (is_there) return;
      if (patience.is_time_to_ask()) look_for(X, here, [&] { return shared->position(X) >= from; });
    }
  }
  template <int X>
  CCA_INLINE void count_late_from(std::int64_t k, int& lost, loop_observers to) noexcept {
    if constexpr (least_delay(X, E) > 0 && !is_free && !is_free_running<D, X>) {
      std::int64_t& in_a_row = this->late_in_a_row[X];
      const bool is_late = !has_done<X>(k - least_delay(X, E) + 1);
      if (is_late) {
        add(shared->environments[E].late[X], 1);
        to.late(X, k);
      }
      in_a_row = is_late ? in_a_row + 1 : 0;
      if (in_a_row > environments_of<D>::tolerated) lost = X;
    }
  }

  template <int Output>
  auto& next_of() noexcept {
    return static_cast<next_arrival<shared_by_all, shared_output_of<D, Output>>&>(*this);
  }
};

}  // namespace cca::detail
