// The stored samples of an output whose component runs in another environment.
#pragma once

#include <cstdint>

#include <cca/runtime/samples/stored_samples.hpp>

namespace cca::detail {

// The last samples that came from another environment. One that comes late arrives when it comes.
template <int Size, int Depth>
class arriving_samples {
public:
  // It was published in beat `published_in`, and is here when beat `came` begins.
  template <class Vector>
  void put(const Vector& v, std::int64_t origin, std::int64_t published_in, std::int64_t came) {
    slot& s = slots[static_cast<std::size_t>(count++) & (array_size(Depth) - 1)];
    s.store(v, origin);
    s.published_in = published_in;
    s.came = came;
  }
  CCA_INLINE const stored_sample<Size>* show(std::int64_t k, int delay) const {
    return newest_arrived(k, delay);
  }
  CCA_INLINE std::int64_t arrived(std::int64_t k, int delay) const {
    const slot* s = newest_arrived(k, delay);
    return !s ? -1 : s->came > s->published_in + delay ? s->came : s->published_in + delay;
  }

  // Of a set of modes: its component comes, and has published nothing.
  void forget() { count = 0; }

private:
  struct slot : stored_sample<Size> {
    std::int64_t published_in = -1, came = -1;
  };

  CCA_INLINE const slot* newest_arrived(std::int64_t k, int delay) const {
    for (std::int64_t n = count - 1; n >= 0 && n > count - 1 - Depth; --n)
      if (const slot& s = slots[static_cast<std::size_t>(n) & (array_size(Depth) - 1)];
          s.published_in + delay <= k)
        return &s;
    return nullptr;
  }

  slot slots[array_size(Depth)];
  std::int64_t count = 0;
};

// The same in a free-running environment, whose cycles are its own beats: `k` counts them. What it reads has
// beats, and several of them, or none, may pass in a cycle.
template <int Size, int Depth>
class samples_for_cycles {
public:
  // Cycle `k` begins in this beat.
  void begin(std::int64_t in_beat) {
    beat_before = beat;
    beat = in_beat;
  }
  template <class Vector>
  void put(const Vector& v, std::int64_t origin, std::int64_t published_in, std::int64_t k) {
    slot& s = slots[static_cast<std::size_t>(count++) & (array_size(Depth) - 1)];
    s.store(v, origin);
    s.published_in = published_in;
    s.came = k;
  }
  void forget() { count = 0; }
  const stored_sample<Size>* show(std::int64_t, int delay) const { return newest_arrived(delay); }
  // In this cycle, or in one before.
  std::int64_t arrived(std::int64_t k, int delay) const {
    const slot* s = newest_arrived(delay);
    return !s ? -1 : s->came == k || s->published_in + delay > beat_before ? k : k - 1;
  }

private:
  struct slot : stored_sample<Size> {
    std::int64_t published_in = -1, came = -1;
  };

  const slot* newest_arrived(int delay) const {
    for (std::int64_t n = count - 1; n >= 0 && n > count - 1 - Depth; --n)
      if (const slot& s = slots[static_cast<std::size_t>(n) & (array_size(Depth) - 1)];
          s.published_in + delay <= beat)
        return &s;
    return nullptr;
  }

  slot slots[array_size(Depth)];
  std::int64_t count = 0, beat = -1, beat_before = -1;
};

}  // namespace cca::detail
