// What the environments of a deployment share: one block of atomic numbers, in the memory of a process or
// between processes. Each number has one writer. Nobody locks, and a writer never waits for a reader.
//
// A position counts beats and the calls in them: in beat k, behind the call of rank r in the whole graph, it
// is k * calls_and_one + r + 1; when beat k is done it is (k + 1) * calls_and_one.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <limits>

#include <cca/graph/plan/part.hpp>
#include <cca/runtime/environments/crossing.hpp>

namespace cca::detail {

inline constexpr std::int64_t no_position = std::numeric_limits<std::int64_t>::max();

// Messages from one writer to one reader, in a ring that the writer goes on filling: a reader that is too slow
// finds that some are lost. Each word is atomic and a number says which message a slot has, so a message that
// is being overwritten is seen as such.
template <int Words, int Capacity>
class message_ring {
public:
  using message = std::array<std::uint64_t, array_size(Words)>;

  // The writer's.
  void put(const message& words) noexcept {
    slot& s = slots[index(count)];
    s.number.store(2 * count + 1, std::memory_order_relaxed);
    for (std::size_t w = 0; w < words.size(); ++w) s.words[w].store(words[w], std::memory_order_release);
    s.number.store(2 * ++count, std::memory_order_release);
  }

  // The reader's: message number `next`, or a later one where that is lost. False: it has not come.
  bool take(std::uint64_t& next, message& words) const noexcept {
    for (;;) {
      const slot& s = slots[index(next)];
      const std::uint64_t before = s.number.load(std::memory_order_acquire);
      if (before < 2 * (next + 1)) return false;
      if (before == 2 * (next + 1)) {
        for (std::size_t w = 0; w < words.size(); ++w)
          words[w] = s.words[w].load(std::memory_order_acquire);
        if (s.number.load(std::memory_order_relaxed) == before) return ++next, true;
      }
      next = before / 2 - Capacity + 2;  // the oldest that is surely not being written
    }
  }

private:
  static std::size_t index(std::uint64_t number) {
    return static_cast<std::size_t>(number) & (array_size(Capacity) - 1);
  }
  struct slot {
    std::atomic<std::uint64_t> number{0};
    std::array<std::atomic<std::uint64_t>, array_size(Words)> words{};
  };

  std::array<slot, array_size(Capacity)> slots{};
  std::uint64_t count = 0;
};

// How many beats an environment may be ahead of those that read from it, and of the first one, as fast as
// possible.
inline constexpr std::int64_t most_ahead = 16;

template <class D, int From, int To, bool Crosses = crossing<D, From, To>::count != 0>
struct channel {
  using link = crossing<D, From, To>;
  // Unread are at most the messages of the beats in which the writer is ahead, and those that are not due.
  static constexpr int capacity =
      static_cast<int>(std::bit_ceil(static_cast<unsigned>(most_ahead + link::least_delay + 2)));
  message_ring<link::words, capacity> ring;
};
template <class D, int From, int To>
struct channel<D, From, To, false> {};

// One per environment, in a cache line of its own.
struct alignas(64) environment_record {
  std::atomic<std::int64_t> position{0};
  // Of the first environment at wall-clock speed: the newest beat begun, when, and the period in ns.
  std::atomic<std::int64_t> begun{-1}, begun_at{0}, interval{0};
};

struct alignas(64) fault_record {
  std::atomic<std::int64_t> position{no_position};
  std::atomic<const char*> reason{nullptr};
  std::atomic<int> node{-1};

  // The first to state a fault is the cause.
  void state(std::int64_t at, const char* why, int component) noexcept {
    std::int64_t none = no_position;
    if (!is_stated.exchange(true)) {
      reason.store(why, std::memory_order_relaxed);
      node.store(component, std::memory_order_relaxed);
      position.compare_exchange_strong(none, at, std::memory_order_release);
    }
  }
  void forget() noexcept {
    position.store(no_position);
    is_stated.store(false);
  }

private:
  std::atomic<bool> is_stated{false};
};

template <class D, class Pairs = std::make_integer_sequence<int, environment_count<D> * environment_count<D>>>
struct exchange;
template <class D, int... Pair>
struct exchange<D, std::integer_sequence<int, Pair...>>
    : channel<D, Pair / environment_count<D>, Pair % environment_count<D>>... {
  static constexpr std::int64_t calls_and_one = counts_of<D>.order_count + 1;
  static constexpr std::int64_t position_of(std::int64_t beat, int done = 0) {
    return beat * calls_and_one + done;
  }

  std::array<environment_record, array_size(environment_count<D>)> environments{};
  fault_record fault{};
  std::atomic<std::int64_t> stop_at{no_position};  // no beat from this one on
  std::atomic<bool> should_stop{false};

  template <int From, int To>
  auto& ring() {
    return static_cast<channel<D, From, To>&>(*this).ring;
  }
  std::int64_t position(int environment) const noexcept {
    return environments[array_size(environment)].position.load(std::memory_order_acquire);
  }
  void move_to(int environment, std::int64_t position) noexcept {
    environments[array_size(environment)].position.store(position, std::memory_order_release);
  }
};

}  // namespace cca::detail
