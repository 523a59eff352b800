// Samples in queues: those that wait at an input, and those that are on their way to a queue because their
// wire is delayed. Plain values, as all stored samples (runtime/samples/stored_samples.hpp).
#pragma once

#include <cstdint>

#include <cca/base/array_size.hpp>
#include <cca/base/inlining.hpp>
#include <cca/graph/plan/items.hpp>
#include <cca/runtime/samples/stored_samples.hpp>
#include <cca/space/origin.hpp>

namespace cca::detail {

// Where wires of two kinds are merged: for whom a sample counts, for the origin of what is made from it. Bit
// 0 is the component's that takes it, the others are those of observers (graph/planning/steps/feedback.hpp).
template <int Size, bool Varies>
struct waiting_sample : stored_sample<Size> {
  CCA_INLINE void mark(std::uint64_t) {}
};
template <int Size>
struct waiting_sample<Size, true> : stored_sample<Size> {
  std::uint64_t counts_for = 1;
  CCA_INLINE void mark(std::uint64_t whom) { counts_for = whom; }
};

// How many samples have come in the newest beat in which any came, where a strategy may ask.
template <bool AreCounted>
struct counted_arrivals {
  CCA_INLINE void count_arrival(std::int64_t) {}
};
template <>
struct counted_arrivals<true> {
  std::int64_t newest = -1;
  int in_newest = 0;
  CCA_INLINE void count_arrival(std::int64_t k) {
    in_newest = newest == k ? in_newest + 1 : 1;
    newest = k;
  }
  CCA_INLINE int arrivals(std::int64_t k) const { return newest == k ? in_newest : 0; }
};

// Samples that wait at an input, and the one that its component took last.
template <int Size, int Capacity, full_kind Full, bool CountsVary, bool CountsArrivals>
class waiting_samples : public counted_arrivals<CountsArrivals> {
public:
  // In beat k. False: it was full, and a sample is lost.
  template <class Vector>
  CCA_INLINE bool put(const Vector& v, std::int64_t origin, std::int64_t k, std::uint64_t counts_for) {
    this->count_arrival(k);
    const bool has_room = count < Capacity;
    if (!has_room) {
      lose(1);
      if constexpr (Full != full_kind::drop_oldest) return false;
      remove_oldest();
    }
    const int end = head + count, at = end < Capacity ? end : end - Capacity;
    ring[at].store(v, origin);
    ring[at].mark(counts_for);
    ++count;
    return has_room;
  }

  // The oldest that waits, or else what was taken last.
  CCA_INLINE const waiting_sample<Size, CountsVary>* show(std::int64_t = 0, int = 0) const {
    const waiting_sample<Size, CountsVary>& oldest = count > 0 ? ring[head] : taken;
    return oldest.origin() == never ? nullptr : &oldest;
  }
  CCA_INLINE std::int64_t arrived(std::int64_t k, int = 0) const { return count > 0 ? k : -1; }
  CCA_INLINE bool is_empty() const { return count == 0; }
  CCA_INLINE int waiting() const { return count; }
  // Samples that a full queue has lost, since there is one.
  CCA_INLINE std::int64_t dropped() const { return lost; }
  CCA_INLINE void lose(std::int64_t samples) { lost += samples; }

  // Removes the sample that the component has seen.
  CCA_INLINE void take() {
    if (count == 0) return;
    taken = ring[head];
    remove_oldest();
  }
  void forget() {
    taken.forget();
    head = count = 0;
  }

private:
  CCA_INLINE void remove_oldest() {
    head = head + 1 == Capacity ? 0 : head + 1;
    --count;
  }

  waiting_sample<Size, CountsVary> ring[array_size(Capacity)];
  waiting_sample<Size, CountsVary> taken;
  int head = 0, count = 0;
  std::int64_t lost = 0;
};

// ---- on_the_way ----

// How many samples are missing before this one: only where several of one beat are played again.
template <bool IsPlayed>
struct missing_samples {
  static constexpr std::int64_t missing = 0;
};
template <>
struct missing_samples<true> {
  std::int64_t missing = 0;
};

// Samples of a delayed wire that have not yet entered the queue at its end. A component publishes at most one
// in a beat, and those that have arrived leave when a beat begins: so there are never more than `Delay`. In a
// replay they may be `InABeat` times as many.
template <int Size, int Delay, int InABeat = 1>
class coming_samples {
public:
  struct sample : stored_sample<Size>, missing_samples<(InABeat > 1)> {
    std::int64_t published_in = -1;
  };

  template <class Vector>
  CCA_INLINE void put(const Vector& v, std::int64_t origin, std::int64_t k) {
    const int at = head + count;
    sample& s = ring[at < room ? at : at - room];
    s.store(v, origin);
    s.published_in = k;
    ++count;
  }
  template <class Vector>
  void put_after(std::int64_t missing, const Vector& v, std::int64_t origin, std::int64_t k) {
    const int at = head + count;
    put(v, origin, k);
    ring[at < room ? at : at - room].missing = missing;
  }
  // The oldest, if it has arrived when beat k begins.
  CCA_INLINE const sample* next(std::int64_t k) const {
    return count > 0 && ring[head].published_in + Delay <= k ? &ring[head] : nullptr;
  }
  CCA_INLINE void remove() {
    head = head + 1 == room ? 0 : head + 1;
    --count;
  }
  void forget() { head = count = 0; }

private:
  static constexpr int room = Delay * InABeat;

  sample ring[array_size(room)];
  int head = 0, count = 0;
};

}  // namespace cca::detail
