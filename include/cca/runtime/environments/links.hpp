// What an environment keeps beside its components and samples: what it is about to send to the others, what
// has come from them and is not due yet, and, as fast as possible, where in a beat it waits for them.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include <cca/runtime/environments/exchange.hpp>
#include <cca/runtime/environments/patience.hpp>

namespace cca::detail {

// The samples of this beat that another environment reads.
template <class D, int From, int To, bool Crosses = crossing<D, From, To>::count != 0>
struct outbox {
  typename crossing<D, From, To>::message message{};
  bool is_empty = true;
};
template <class D, int From, int To>
struct outbox<D, From, To, false> {};

// The next message of another environment.
template <class D, int From, int To, bool Crosses = crossing<D, From, To>::count != 0>
struct inbox {
  typename crossing<D, From, To>::message message{};
  std::uint64_t next = 0;
  bool has_one = false;
  std::int64_t late_in_a_row = 0;
};
template <class D, int From, int To>
struct inbox<D, From, To, false> {};

// In the order of a beat of the whole: the last call before rank `before` that may fault, of an environment;
// as the number of calls done with it, 0: none.
constexpr int last_that_may_fault(const flat_view& whole, int environment, int before) {
  for (int r = before - 1; r >= 0; --r)
    if (const auto& c = whole.calls[whole.order[r]];
        environment_of(whole, whole.order[r]) == environment && may_fault_in(whole, c))
      return r + 1;
  return 0;
}

template <class D, int E>
inline constexpr int last_fault_of = [] {
  auto plan = plan_of<D>;
  const auto whole = plan.view();
  return last_that_may_fault(whole, E, whole.call_count);
}();

// Before call `Rank` of a part: how far the other environment must be. The same as before the call in front
// of it: nothing to wait for.
template <class D, int E, int Rank, int Other>
struct gate {
  static constexpr int whole_rank(int rank) {
    return rank < 0 ? 0 : plan_of<D>.calls[array_size(plan_of<part<D, E>>.order[array_size(rank)])].rank;
  }
  static constexpr int needed(int rank) {
    auto plan = plan_of<D>;
    return last_that_may_fault(plan.view(), Other, whole_rank(rank));
  }
  static constexpr int value = needed(Rank);
  static constexpr bool is_new = Other != E && value > 0 && (Rank == 0 || needed(Rank - 1) != value);
};

template <class D, int E, class Others = std::make_integer_sequence<int, environment_count<D>>>
struct environment_links;
template <class D, int E, int... Other>
struct environment_links<D, E, std::integer_sequence<int, Other...>>
    : outbox<D, E, Other>..., inbox<D, Other, E>... {
  exchange<D>* shared = nullptr;
  bool is_exact = false;  // as fast as possible: wait for whatever a result depends on
  bool is_cut = false;    // a fault elsewhere came before the next call of this beat

  // A component publishes.
  template <int Output, class Vector>
  CCA_INLINE void send(const Vector& v, std::int64_t origin) {
    (send_to<Other, Output>(v, origin), ...);
  }

  // At the end of beat k. What was not published is not sent: the writer's position says that it is not.
  void send_all(std::int64_t k) noexcept {
    (flush<Other>(k), ...);
  }

  // When beat k begins: takes what was published before it, into the samples that the components read.
  template <class State>
  void receive_all(State& state, std::int64_t k) noexcept {
    (receive<Other>(state, k), ...);
  }

  // Nothing has gone wrong elsewhere before this call. False: the beat ends here.
  template <int Rank>
  CCA_INLINE bool is_due(std::int64_t k) noexcept {
    if constexpr ((gate<D, E, Rank, Other>::is_new || ...)) {
      if (is_exact && !is_cut) (wait_for<Rank, Other>(k), ...);
    }
    return !is_cut;
  }
  // The call of this rank is done; others may wait for it.
  template <int Rank>
  CCA_INLINE void is_done(std::int64_t k) noexcept {
    constexpr int call = plan_of<part<D, E>>.order[Rank];
    constexpr bool matters = [] {
      auto plan = plan_of<D>;
      return may_fault_in(plan.view(), plan.calls[call]);
    }();
    if constexpr (matters)
      shared->move_to(E, exchange<D>::position_of(k, plan_of<D>.calls[call].rank + 1));
  }

private:
  template <int To, int Output, class Vector>
  CCA_INLINE void send_to(const Vector& v, std::int64_t origin) {
    constexpr int number = crossing<D, E, To>::number_of(Output);
    if constexpr (number >= 0) {
      auto& box = static_cast<outbox<D, E, To>&>(*this);
      crossing<D, E, To>::template write<number>(box.message, v, origin);
      box.is_empty = false;
    }
  }
  template <int To>
  void flush(std::int64_t k) noexcept {
    if constexpr (crossing<D, E, To>::count != 0) {
      auto& box = static_cast<outbox<D, E, To>&>(*this);
      if (box.is_empty) return;
      box.message[0] = static_cast<std::uint64_t>(k);
      shared->template ring<E, To>().put(box.message);
      for (int w = 0; w < (crossing<D, E, To>::count + 63) / 64; ++w) box.message[array_size(1 + w)] = 0;
      box.is_empty = true;
    }
  }
  template <int From, class State>
  void receive(State& state, std::int64_t k) noexcept {
    if constexpr (crossing<D, From, E>::count != 0) {
      auto& box = static_cast<inbox<D, From, E>&>(*this);
      for (;;) {
        if (!box.has_one) box.has_one = shared->template ring<From, E>().take(box.next, box.message);
        if (!box.has_one || static_cast<std::int64_t>(box.message[0]) >= k) return;
        crossing<D, From, E>::deliver(state, box.message, k);
        box.has_one = false;
      }
    }
  }
  template <int Rank, int X>
  void wait_for(std::int64_t k) noexcept {
    using before = gate<D, E, Rank, X>;
    if constexpr (before::is_new) {
      const auto needed = exchange<D>::position_of(k, before::value);
      patience patient;
      while (shared->position(X) < needed && !is_cut) {
        is_cut = shared->fault.position.load(std::memory_order_acquire) <=
                 exchange<D>::position_of(k, before::whole_rank(Rank));
        if (!is_cut) patient.wait();
      }
    }
  }
};

// The state of a part has its links, which the beat finds by its context.
template <class D, int E>
struct controller_state<part<D, E>>
    : state_of<part<D, E>,
               chosen<counts_of<part<D, E>>.node_count, is_first_of_type<part<D, E>>>,
               chosen<layout_of<part<D, E>>.array_count, outlives_beat<part<D, E>>>>,
      environment_links<D, E> {};

}  // namespace cca::detail
