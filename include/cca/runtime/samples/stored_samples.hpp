// Stored samples: each type knows how it is stored, what it shows in beat k, and when that arrived.
//
//   put(coordinates, origin, k)   a sample is published in beat k
//   show(k, delay)                what a reader with this delay sees in beat k; null: nothing has arrived yet
//   arrived(k, delay)             the beat in which that arrived; -1: nothing has
//
// Which type an output has is decided in graph/planning/steps/storage.hpp. All of them are plain values: a
// copy is a snapshot.
#pragma once

#include <cstdint>
#include <new>
#include <tuple>
#include <utility>

#include <cca/base/array_size.hpp>
#include <cca/base/copy_block.hpp>
#include <cca/base/eigen.hpp>
#include <cca/base/inlining.hpp>
#include <cca/component/fault.hpp>
#include <cca/component/clock.hpp>
#include <cca/graph/plan/items.hpp>
#include <cca/space/origin.hpp>

namespace cca::detail {

// Coordinates and time of origin. Eigen's vectors are not trivially copyable, but a controller of trivial
// components is: so the vector lives in bytes. Through std::launder the compiler knows nothing about what
// it reads, so only small ones, which need no loop, are read through it (docs/compilers.md).
template <int Size>
class stored_sample {
  using vector_type = Eigen::Matrix<double, Size, 1>;

public:
  stored_sample() { ::new (static_cast<void*>(bytes)) vector_type(vector_type::Zero()); }

  CCA_INLINE vector_type& vector() {
    if constexpr (Size <= 4) return *std::launder(reinterpret_cast<vector_type*>(bytes));
    else return *reinterpret_cast<vector_type*>(bytes);
  }
  CCA_INLINE const vector_type& vector() const {
    if constexpr (Size <= 4) return *std::launder(reinterpret_cast<const vector_type*>(bytes));
    else return *reinterpret_cast<const vector_type*>(bytes);
  }
  CCA_INLINE std::int64_t origin() const { return time; }
  void forget() { time = never; }
  // What it shows until a sample is stored.
  void begin_with(int coordinate, double initial) { vector()[coordinate] = initial; }

  template <class Vector>
  CCA_INLINE void store(const Vector& v, std::int64_t origin) {
    if constexpr (Size >= least_block && requires { v.data(); }) copy_block<Size>(vector().data(), v.data());
    else vector() = v;
    time = origin;
  }

private:
  // From so many coordinates on, a copy as a block is faster than Eigen's loop.
  static constexpr int least_block = 32;

  alignas(vector_type) unsigned char bytes[sizeof(vector_type)];
  std::int64_t time = never;
};

// The newest beat up to k in which a known clock ticks; -1 if none.
constexpr std::int64_t newest_tick(clock c, std::int64_t k) {
  if (k < c.first) return -1;
  return c.period == 1 ? k : k - (k - c.first) % c.period;
}

// ---- of_beat ----

// How many outputs a result has; a fault, a request and `done` are none.
template <class Result>
inline constexpr int outputs_in = 1;
template <class... Outputs>
inline constexpr int outputs_in<std::tuple<Outputs...>> =
    (0 + ... + (result_facts<Outputs>::kind == result_kind::output));

// Which outputs were published in this beat. A result of each beat needs no marks.
template <int Count>
struct published_marks {
  bool is_published[array_size(Count)] = {};
};
template <>
struct published_marks<0> {};

// What a component returned, where it returned it. Nobody reads it in a later beat. It lives in bytes: in a
// union each coordinate that is written might change the origin (docs/compilers.md).
template <class Result, bool InEachBeat>
class result_of_beat : published_marks<InEachBeat ? 0 : outputs_in<Result>> {
public:
  CCA_INLINE result_of_beat() {}

  // Where the result is to be built.
  CCA_INLINE void* place() { return bytes; }
  // The output number `Position` of it is published.
  template <int Position>
  CCA_INLINE void put() {
    if constexpr (!InEachBeat) this->is_published[Position] = true;
  }

  // The output number `Position` among the results.
  template <int Position>
  CCA_INLINE const auto& output() const {
    if constexpr (index_of<Position>(static_cast<Result*>(nullptr)) < 0) return result();
    else
      return std::get<static_cast<std::size_t>(index_of<Position>(static_cast<Result*>(nullptr)))>(result());
  }
  template <int Position>
  CCA_INLINE std::int64_t arrived(std::int64_t k) const {
    if constexpr (!InEachBeat) return this->is_published[Position] ? k : -1;
    else if constexpr (requires { output<Position>().operator bool(); }) return output<Position>() ? k : -1;
    else return k;
  }

private:
  // The index of an output in a tuple of results; -1 if the result is an output and no tuple.
  template <int Position, class Output>
  static constexpr int index_of(const Output*) {
    return -1;
  }
  template <int Position, class... Outputs>
  static constexpr int index_of(const std::tuple<Outputs...>*) {
    constexpr bool is_output[] = {result_facts<Outputs>::kind == result_kind::output...};
    int found = 0;
    for (int seen = -1; (seen += is_output[found]) < Position;) ++found;
    return found;
  }

  CCA_INLINE const Result& result() const { return *reinterpret_cast<const Result*>(bytes); }

  alignas(Result) unsigned char bytes[sizeof(Result)];
};

// ---- newest ----

// The beat of the last publication, where the clock doesn't tell.
template <bool IsStored>
struct publication_beat {
  std::int64_t published_in = -1;
};
template <>
struct publication_beat<false> {};

// The newest sample. It holds an initial value, of origin `never`, until there is one.
template <int Size, clock Published>
struct newest_sample : stored_sample<Size>, publication_beat<Published.dynamic()> {
  template <class Vector>
  CCA_INLINE void put(const Vector& v, std::int64_t origin, [[maybe_unused]] std::int64_t k) {
    this->store(v, origin);
    if constexpr (Published.dynamic()) this->published_in = k;
  }
  CCA_INLINE const stored_sample<Size>* show(std::int64_t, int) const { return this; }
  CCA_INLINE std::int64_t arrived([[maybe_unused]] std::int64_t k, [[maybe_unused]] int delay) const {
    if constexpr (Published.never()) return -1;
    else if constexpr (Published.known()) return newest_tick(shifted(Published, delay), k);
    else return this->published_in < 0 ? -1 : this->published_in + delay;
  }
  // It has not been published yet.
  void forget() {
    stored_sample<Size>::forget();
    if constexpr (Published.dynamic()) this->published_in = -1;
  }
  // In beat k it should have been published and was not: it counts again.
  void repeat(std::int64_t k)
    requires(Published.dynamic())
  {
    this->published_in = k;
  }
};

// ---- past ----

// The last samples. Depth is a power of two, and enough for all readers. What has not been published yet is
// where nothing has been stored: there it holds the initial value, of origin `never`, so a reader needs no
// test.
// `MarksBeats`: each keeps the beat in which it was published. Where nothing can keep an output from being
// published when its clock ticks, the clock tells.
template <int Size, int Depth, clock Published, bool MarksBeats>
class past_samples {
  static_assert(MarksBeats || Published.known());

public:
  template <class Vector>
  CCA_INLINE void put(const Vector& v, std::int64_t origin, std::int64_t k) {
    slot& s = slots[index_in_ring(Published.known() ? (k - Published.first) / Published.period : count++)];
    s.store(v, origin);
    if constexpr (MarksBeats) s.published_in = k;
  }
  CCA_INLINE const stored_sample<Size>* show(std::int64_t k, int delay) const {
    return &newest_arrived(k, delay);
  }
  CCA_INLINE std::int64_t arrived(std::int64_t k, int delay) const {
    if constexpr (MarksBeats) {
      const slot& s = newest_arrived(k, delay);
      return s.published_in < 0 ? -1 : s.published_in + delay;
    } else {
      return newest_tick(shifted(Published, delay), k);
    }
  }
  // In beat k nothing was published: if its clock ticks, the sample before counts again.
  void repeat(std::int64_t k)
    requires(MarksBeats)
  {
    if constexpr (Published.dynamic()) return repeat_last(k);
    if (!ticks(Published, k)) return;
    const std::int64_t number = (k - Published.first) / Published.period;
    slot& now = slots[index_in_ring(number)];
    if (now.published_in == k) return;
    if (number > 0) now = slots[index_in_ring(number - 1)];
    if (now.published_in >= 0) now.published_in = k;
  }
  void forget() {
    for (slot& each : slots) {
      each.forget();
      if constexpr (MarksBeats) each.published_in = -1;
    }
    count = 0;
  }
  void begin_with(int coordinate, double initial) {
    for (slot& each : slots) each.begin_with(coordinate, initial);
  }

private:
  struct slot : stored_sample<Size>, publication_beat<MarksBeats> {};

  CCA_INLINE static std::size_t index_in_ring(std::int64_t number) {
    return static_cast<std::size_t>(number) & static_cast<std::size_t>(Depth - 1);
  }

  void repeat_last(std::int64_t k) {
    if (count == 0 || slots[index_in_ring(count - 1)].published_in == k) return;
    slots[index_in_ring(count)] = slots[index_in_ring(count - 1)];
    slots[index_in_ring(count++)].published_in = k;
  }

  // A number below 0: nothing has arrived. There are fewer samples than slots then, so that slot is empty.
  CCA_INLINE const slot& newest_arrived(std::int64_t k, int delay) const {
    std::int64_t number = -1;
    if constexpr (Published.known()) {
      number = k - delay - Published.first;
      if constexpr (Published.period > 1) number = number < 0 ? -1 : number / Published.period;
    } else {
      number = count - 1;
      // At most `Depth` samples are newer than the one that has arrived: older ones have been overwritten.
      while (number >= 0 && slots[index_in_ring(number)].published_in + delay > k) --number;
    }
    return slots[index_in_ring(number)];
  }

  slot slots[array_size(Depth)];
  std::int64_t count = 0;
};

}  // namespace cca::detail
