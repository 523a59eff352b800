// How a deployment makes changes of parts and modes that the program or another thread asks for: at once
// where no environment computes, else by an order (agreed_changes.hpp). `Self` is the deployment.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include <cca/runtime/environments/loop/environment_loops.hpp>

namespace cca::detail {

template <class Self, class D>
class ordered_changes {
protected:
  // No environment computes: between two runs, and between two beats of a fast run in one process.
  bool is_at_rest() const { return !is_computing || (is_exact && !self().others); }
  void begin_run(bool exact) {
    is_exact = exact;
    is_computing = true;
  }
  void end_run() { is_computing = false; }

  // The number of the first environment of this process; its thread gives the orders.
  int first_here() const {
    return static_cast<int>(std::ranges::find(self().here, true) - self().here.begin());
  }
  std::int64_t next_of_first_here() const {
    std::int64_t next = 0;
    self().loops.for_each([&]<int E>(const auto& loop) {
      if (E == first_here()) next = loop.beat_of_change();
    });
    return next;
  }

  // Where its environment is, if that looks at it now; else all are at rest.
  std::int64_t next_beat_of(int environment) const {
    const std::int64_t own = self().looked_at[array_size(environment)];
    return own > 0 ? own : self().beat_index();
  }
  // What another thread asks for: a part, or, below 0, the mode. A part that one environment of this process
  // has is stopped in the thread of that one. But where components may ask for it in the same beat, an order
  // comes after them; and where modes may lack it, an order comes after those for modes.
  bool needs_order(int part) const {
    return part < 0 || is_spread_part<D>(part) || !self().is_part_here(part) || is_asked_for<D>(part) ||
           (DeploymentOfModes<D> && !is_part_of<D>(part, first_here()));
  }
  // From the thread of the first environment here. The beat in which it has effect.
  std::int64_t order([[maybe_unused]] ordered what, [[maybe_unused]] int number) {
    std::int64_t in = 0;
    if constexpr (has_orders<D>)
      self().loops.for_each([&]<int E>(auto& loop) {
        if (E != first_here()) return;
        const std::int64_t next = is_exact ? loop.k : self().shared->environments[0].begun + 1;
        in = beat_of_order<D>(next, is_exact);
        send_order<D, E>(*self().shared, what, number, in, is_exact);
      });
    return in;
  }
  void order_at_rest(int part, bool stops) {
    wish(part, stops);
    set_part_here(part, stops);
  }

  // Between two runs, of a part that another process runs.
  void wish(int part, bool stops) {
    if (self().is_part_here(part)) return;
    std::int64_t& one = wishes[array_size(part)];
    if (stops) one = one == no_wish || one == wish_to_stop ? wish_to_stop : wish_to_start_and_stop;
    else one = one == no_wish || one == wish_to_start ? wish_to_start : wish_to_stop_and_start;
  }
  void forget_wishes() { wishes = {}; }
  // Before the environments meet for a run.
  void tell_wishes() {
    if constexpr (has_wishes)
      for (std::size_t e = 0; e < self().here.size(); ++e)
        for (std::size_t p = 0; self().here[e] && p < wishes.size(); ++p)
          self().shared->wishes[e][p] = wishes[p];
  }
  // When they have met: of several for one part that of the environment which stands first. The process that
  // asked has its own share of the part as it was asked for.
  void obey_wishes() {
    if constexpr (has_wishes)
      for (int p = 0; p < counts_of<D>.part_count; ++p) {
        std::size_t first = 0;
        const auto& all = self().shared->wishes;
        while (first < all.size() && all[first][array_size(p)] == no_wish) ++first;
        if (first == all.size() || self().here[first]) continue;
        const std::int64_t wanted = all[first][array_size(p)];
        const bool stops = wanted == wish_to_stop || wanted == wish_to_start_and_stop;
        if (wanted == wish_to_stop_and_start || wanted == wish_to_start_and_stop) set_part_here(p, !stops);
        set_part_here(p, stops);
      }
    forget_wishes();
  }
  // While others compute.
  bool is_ordered(int part, bool stops) {
    if (is_at_rest()) wish(part, stops);
    if (is_at_rest() || is_part_of<D>(part, first_here())) return false;
    order(stops ? ordered::stop : ordered::start, part);
    return true;
  }
  // In the thread of an environment, between two of its beats.
  template <int E>
  void set_part_in(int part, bool stops) {
    self().loops.template at<E>().set_part(part, stops, Self::template next_of<E>(self()), next_beat_of(E));
  }

  // Before `between` looks at them, they have what their components asked for, as in one loop.
  void take_changes_at_rest() {
    if constexpr (asks_for_anything)
      if (is_at_rest())
        self().loops.for_each([&]<int E>(auto& loop) { loop.take_changes(self().beat_index()); });
  }

  bool is_exact = true, is_computing = false;  // the run

private:
  static constexpr bool asks_for_anything = [] {
    for (int e = 0; e < environment_count<D>; ++e)
      if (asks_for_changes<D>(e)) return true;
    return false;
  }();
  static constexpr bool has_wishes = counts_of<D>.part_count > 0 && environment_count<D> > 1;
  void set_part_here(int part, bool stops) {
    self().loops.for_each([&]<int E>(auto& loop) {
      if (self().here[E]) loop.set_part(part, stops, Self::template next_of<E>(self()), next_beat_of(E));
    });
  }

  std::array<std::int64_t, array_size(has_wishes ? counts_of<D>.part_count : 1)> wishes{};

  Self& self() { return static_cast<Self&>(*this); }
  const Self& self() const { return static_cast<const Self&>(*this); }
};

}  // namespace cca::detail
