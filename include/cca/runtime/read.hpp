// What an input sees when its component fires.
#pragma once

#include <cca/runtime/inlining.hpp>
#include <cca/runtime/memory.hpp>

namespace cca::detail {

template <class To, class From, int... C>
CCA_GLUE void copy_each(To& to, const From& from, std::integer_sequence<int, C...>) {
  ((to[C] = from[C]), ...);
}

// Element by element up to sixteen: a packet copy after scalar stores stalls.
template <int Size, class To, class From>
CCA_GLUE void copy_coordinates(To& to, const From& from) {
  if constexpr (Size <= 16) {
    copy_each(to, from, std::make_integer_sequence<int, Size>{});
  } else {
    for (int c = 0; c < Size; ++c) to[c] = from[c];
  }
}

// Coordinate c of the initial value of an input.
template <class Graph, int Input>
constexpr double initial_coordinate(int c) {
  constexpr const item_info* wire = input_of<Graph, Input>.wire;
  if constexpr (wire && wire->initial) return wire->initial[wire->initial_count == 1 ? 0 : c];
  return 0;
}

template <class Graph, int Input, class To>
CCA_GLUE void set_initial(To& to) {
  constexpr int size = size_of_input<Graph, Input>;
  [&]<int... C>(std::integer_sequence<int, C...>) { ((to[C] = initial_coordinate<Graph, Input>(C)), ...); }(std::make_integer_sequence<int, size>{});
}

// A sample as an input holds it: coordinates, origin (`never`: initial), and the beat of its arrival.
template <int Size>
struct held : coordinates<Size> {
  std::int64_t arrived;  // beat; -1: nothing has
};

// The newest beat up to k in which a known clock, begun `first` beats late, ticks; -1 if none.
constexpr std::int64_t newest_tick(clock c, std::int64_t k) {
  if (k < c.first) return -1;
  return c.period == 1 ? k : k - (k - c.first) % c.period;
}

template <class Graph, int Input, int Delay, int Output>
CCA_GLUE auto hold_past(const past_samples<Graph, Output>& past, std::int64_t k) {
  held<size_of_output<Graph, Output>> h;
  constexpr auto c = published_of<Graph, Output>;
  constexpr auto mask = static_cast<std::size_t>(past_samples<Graph, Output>::size - 1);
  std::int64_t at = -1;
  if constexpr (c.known()) {
    const auto newest = k - Delay;
    at = newest < c.first ? -1 : (newest - c.first) / c.period;
  } else {
    at = past.count - 1;
    // At most `size` samples are newer than the one that has arrived: older ones have been written over.
    while (at >= 0 && past.entries[static_cast<std::size_t>(at) & mask].when + Delay > k) --at;
  }
  if (at < 0) {
    set_initial<Graph, Input>(h.value);
    h.origin = never;
    h.arrived = -1;
  } else {
    const auto& entry = past.entries[static_cast<std::size_t>(at) & mask];
    copy_coordinates<size_of_output<Graph, Output>>(h.value, entry.value);
    h.origin = entry.origin;
    h.arrived = entry.when + Delay;
  }
  return h;
}

// What an input that is no queue holds in beat k.
template <class Graph, int Input>
CCA_GLUE auto hold(const memory<Graph>& m, const locals<Graph>& l, std::int64_t k) {
  constexpr const auto& in = input_of<Graph, Input>;
  constexpr int size = size_of_input<Graph, Input>;
  constexpr int delay = in.wire && in.wire->policy == policy_kind::delayed ? in.wire->number : 0;
  held<size> h;
  if constexpr (in.writer < 0) {
    set_initial<Graph, Input>(h.value);
    h.origin = never;
    h.arrived = -1;
  } else if constexpr (delay > 0 && !in.is_kept) {
    return hold_past<Graph, Input, delay, in.writer>(m, k);
  } else if constexpr (!in.is_kept) {
    const local_sample<Graph, in.writer>& s = l;
    copy_coordinates<size>(h.value, s.value);
    h.origin = s.origin;
    if constexpr (is_sure<Graph, in.writer>) h.arrived = k;
    else h.arrived = s.published ? k : -1;
  } else {
    const kept_sample<Graph, in.writer>& s = m;
    constexpr auto c = published_of<Graph, in.writer>;
    copy_coordinates<size>(h.value, s.value);
    if constexpr (in.own_initial)
      if (s.origin == never) set_initial<Graph, Input>(h.value);
    h.origin = s.origin;
    if constexpr (in.in_beat && c.known()) h.arrived = k;
    else if constexpr (c.known()) h.arrived = newest_tick({c.period, c.first + delay}, k);
    else if constexpr (c.never()) h.arrived = -1;
    else h.arrived = s.when < 0 ? -1 : s.when + delay;
  }
  return h;
}

// What a queue shows: its oldest waiting sample, or what was taken last.
template <class Graph, int Input>
CCA_GLUE auto show_queue(const waiting_samples<Graph, Input>& q, std::int64_t k) {
  constexpr int size = size_of_input<Graph, Input>;
  held<size> h;
  const auto& shown = q.count > 0 ? q.ring[static_cast<std::size_t>(q.head)] : q.taken;
  copy_coordinates<size>(h.value, shown.value);
  if (shown.origin == never) set_initial<Graph, Input>(h.value);
  h.origin = shown.origin;
  h.arrived = q.count > 0 ? k : -1;
  return h;
}

template <class Graph, int Input>
CCA_GLUE auto see(const memory<Graph>& m, const locals<Graph>& l, std::int64_t k) {
  if constexpr (input_of<Graph, Input>.queue >= 0) return show_queue<Graph, Input>(m, k);
  else return hold<Graph, Input>(m, l, k);
}

// A sample has arrived since the component last fired; with a queue, if it is not empty.
template <class Graph, int Input, class Held>
CCA_GLUE bool is_fresh(const Held& h, std::int64_t last) {
  if constexpr (input_of<Graph, Input>.queue >= 0) return h.arrived >= 0;
  else return h.arrived > last;
}

// A port as the component sees it.
template <class Graph, int Input, class Port, class Held>
CCA_GLUE void fill_port(Port& port, const Held& h, std::int64_t last) {
  [&]<int... C>(std::integer_sequence<int, C...>) { (port.set(C, h.value[C]), ...); }(std::make_integer_sequence<int, size_of_input<Graph, Input>>{});
  port.set(h.origin, is_fresh<Graph, Input>(h, last));
  if constexpr (requires { port.set_wired(); } && input_of<Graph, Input>.writer >= 0) port.set_wired();
}

// Removes the sample that the component has just seen.
template <class Graph, int Input>
CCA_GLUE void take(waiting_samples<Graph, Input>& q) {
  if (q.count == 0) return;
  q.taken = q.ring[static_cast<std::size_t>(q.head)];
  q.head = q.head + 1 == q.capacity ? 0 : q.head + 1;
  --q.count;
}

}  // namespace cca::detail
