// What an input sees when its component fires: a value, its origin, and whether it is fresh. Each is a
// function of its own that reads where the sample lies, so that nothing is copied on the way to the port.
#pragma once

#include <cca/base/inlining.hpp>
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

// What an input without a wire sees, or before a first sample has come.
template <class Graph, int Input>
struct initial_sample {
  static constexpr coordinates<size_of_input<Graph, Input>> sample = [] {
    coordinates<size_of_input<Graph, Input>> initial{{}, never};
    for (int c = 0; c < size_of_input<Graph, Input>; ++c)
      initial.value[c] =
          initial_coordinate(input_of<Graph, Input>.wire, *input_port_of<Graph, Input>.space, c);
    return initial;
  }();
};

// The newest beat up to k in which a known clock, begun `first` beats late, ticks; -1 if none.
constexpr std::int64_t newest_tick(clock c, std::int64_t k) {
  if (k < c.first) return -1;
  return c.period == 1 ? k : k - (k - c.first) % c.period;
}

// Where in the past of an output the newest sample lies that has arrived after a delay; null if none has.
template <class Graph, int Output, int Delay, class Past>
CCA_GLUE auto arrived_entry(const Past& past, std::int64_t k) {
  constexpr auto c = published_of<Graph, Output>;
  constexpr auto mask = static_cast<std::size_t>(Past::depth - 1);
  std::int64_t at = -1;
  if constexpr (c.known()) {
    const auto newest = k - Delay;
    at = newest < c.first ? -1 : (newest - c.first) / c.period;
  } else {
    at = past.count - 1;
    // At most `depth` samples are newer than the one that has arrived: older ones have been written over.
    while (at >= 0 && past.entries[static_cast<std::size_t>(at) & mask].when + Delay > k) --at;
  }
  return at < 0 ? nullptr : &past.entries[static_cast<std::size_t>(at) & mask];
}

template <class Graph, int Input>
inline constexpr int delay_of_input = input_of<Graph, Input>.delay;
template <class Graph, int Input>
inline constexpr bool reads_past = delay_of_input<Graph, Input> > 0 && !input_of<Graph, Input>.is_kept;

// The sample itself, wherever it lies. Of a queue: the oldest waiting, or what was taken last.
template <class Graph, int Input>
CCA_GLUE const auto& shown(const input_seat<Graph, Input>& seat, std::int64_t k) {
  constexpr const auto& in = input_of<Graph, Input>;
  using sample = coordinates<size_of_input<Graph, Input>>;
  if constexpr (in.writer < 0) {
    return initial_sample<Graph, Input>::sample;
  } else if constexpr (in.queue >= 0) {
    const sample& oldest = seat.at.count > 0 ? seat.at.ring[seat.at.head] : seat.at.taken;
    return oldest.origin == never ? initial_sample<Graph, Input>::sample : oldest;
  } else if constexpr (reads_past<Graph, Input>) {
    const auto* entry = arrived_entry<Graph, in.writer, delay_of_input<Graph, Input>>(seat.at, k);
    return entry ? static_cast<const sample&>(*entry) : initial_sample<Graph, Input>::sample;
  } else if constexpr (in.own_initial) {
    const sample& kept = seat.at;
    return kept.origin == never ? initial_sample<Graph, Input>::sample : kept;
  } else {
    const sample& newest = seat.at;
    return newest;
  }
}

template <class Graph, int Input>
CCA_GLUE std::int64_t origin_of(const input_seat<Graph, Input>& seat, std::int64_t k) {
  return shown<Graph, Input>(seat, k).origin;
}

// The beat in which the sample arrived; -1: nothing has.
template <class Graph, int Input>
CCA_GLUE std::int64_t arrival_of(const input_seat<Graph, Input>& seat, std::int64_t k) {
  constexpr const auto& in = input_of<Graph, Input>;
  constexpr int delay = delay_of_input<Graph, Input>;
  if constexpr (in.writer < 0) {
    return -1;
  } else if constexpr (in.queue >= 0) {
    return seat.at.count > 0 ? k : -1;
  } else if constexpr (reads_past<Graph, Input>) {
    const auto* entry = arrived_entry<Graph, in.writer, delay>(seat.at, k);
    return entry ? entry->when + delay : -1;
  } else {
    constexpr auto c = published_of<Graph, in.writer>;
    if constexpr (!in.is_kept) {
      if constexpr (is_sure<Graph, in.writer>) return k;
      else return seat.at.published ? k : -1;
    } else if constexpr (in.in_beat && c.known()) return k;
    else if constexpr (c.known()) return newest_tick({c.period, c.first + delay}, k);
    else if constexpr (c.never()) return -1;
    else return seat.at.when < 0 ? -1 : seat.at.when + delay;
  }
}

// A sample has arrived since the component last fired; with a queue, if it is not empty.
template <class Graph, int Input>
CCA_GLUE bool is_fresh(const input_seat<Graph, Input>& seat, std::int64_t k, std::int64_t last) {
  if constexpr (input_of<Graph, Input>.queue >= 0) return seat.at.count > 0;
  else return arrival_of<Graph, Input>(seat, k) > last;
}

template <class Port, class Sample, int... C>
CCA_GLUE void set_coordinates(Port& port, const Sample& from, std::integer_sequence<int, C...>) {
  (port.set(C, from.value[C]), ...);
}

// A port as the component sees it.
template <class Graph, int Input, class Port>
CCA_GLUE void fill_port(Port& port, const input_seat<Graph, Input>& seat, std::int64_t k, std::int64_t last) {
  const auto& sample = shown<Graph, Input>(seat, k);
  set_coordinates(port, sample, std::make_integer_sequence<int, size_of_input<Graph, Input>>{});
  port.set(sample.origin, is_fresh<Graph, Input>(seat, k, last));
  if constexpr (requires { port.set_wired(); } && input_of<Graph, Input>.writer >= 0) port.set_wired();
}

// Removes the sample that the component has just seen.
template <class Queue>
CCA_GLUE void take(Queue& q) {
  if (q.count == 0) return;
  q.taken = q.ring[q.head];
  q.head = q.head + 1 == q.capacity ? 0 : q.head + 1;
  --q.count;
}

}  // namespace cca::detail
