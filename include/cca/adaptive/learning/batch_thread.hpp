// Computes the batches that are requested at a port: a thread beside the loop, for one training.
//
//   ask(examples..., settings)   in a beat: hands over a copy; false while an older batch is still computed
//   take(into)                   in a beat: the result, once it is there
//   give_up()                    in a beat: the result is not wanted any more
//
// A beat never waits, allocates or makes a system call: the thread looks for work every `rest`. One flag says
// whose turn it is, so neither side reads what the other writes. A batch that was given up is computed to its
// end, and its result is lost; only then can another one begin.
//
// A copy has a thread of its own, which computes again what was under way: the same examples give the same
// result. The destructor waits for the batch that is computed. Errors: cca::refused, if the system has no
// more threads. Memory: a copy of the examples, and of a result. Cost: `ask` copies the examples, `take` the
// result; else one atomic load. Used by training.hpp.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <span>
#include <system_error>
#include <thread>
#include <vector>

#include <cca/adaptive/learner.hpp>
#include <cca/base/refused.hpp>
#include <cca/base/system/polled_thread.hpp>

namespace cca::detail {

enum class batch_end : std::uint8_t { not_yet, done, failed };

template <BatchLearner Rule>
class batch_thread {
  using example_type = example<typename Rule::model>;
  using settings_type = typename Rule::settings;
  using learned_type = typename Rule::learned;

public:
  batch_thread() = default;
  batch_thread(const batch_thread& other) {
    if (!other.beside) return;
    start(other.beside->examples.size());
    if (!other.pending) return;
    beside->examples = other.beside->examples;  // the thread only reads them
    beside->count = other.beside->count;
    beside->settings = other.beside->settings;
    hand_over();
  }
  batch_thread(batch_thread&&) = default;
  batch_thread& operator=(batch_thread other) {
    beside = std::move(other.beside);
    pending = other.pending;
    return *this;
  }
  ~batch_thread() = default;

  // Not in a beat. `capacity`: the most examples of a batch.
  void start(std::size_t capacity) {
    if (!beside) beside = std::make_unique<both>(capacity);
  }
  bool is_there() const { return beside != nullptr; }

  // The examples from `oldest` to before `newest`, of all that were ever written into the ring `kept`.
  bool ask(std::span<const example_type> kept,
           std::size_t oldest,
           std::size_t newest,
           const settings_type& with) {
    // Where it has not begun with an older one, that one is taken back.
    auto expected = turn::asked;
    if (!beside->now.compare_exchange_strong(expected, turn::free) && expected == turn::computes)
      return false;
    beside->count = newest - oldest;
    for (std::size_t i = 0; i < beside->count; ++i) beside->examples[i] = kept[(oldest + i) % kept.size()];
    beside->settings = with;
    hand_over();
    return true;
  }
  void give_up() {
    if (!pending) return;
    pending = false;
    auto expected = turn::asked;
    beside->now.compare_exchange_strong(expected, turn::free);
  }
  batch_end take(learned_type& into) {
    if (!pending || beside->now.load(std::memory_order_acquire) != turn::done) return batch_end::not_yet;
    pending = false;
    if (beside->failed) return batch_end::failed;
    into = beside->result;
    return batch_end::done;
  }

private:
  enum class turn : int { free, asked, computes, done };

  struct both {
    explicit both(std::size_t capacity) : examples(capacity) {
      try {
        runs.start([this] { work(); });
      } catch (const std::system_error& error) {
        throw refused(std::string("cca::training: the system gives no thread for the batches that are "
                                  "requested at a port: ") +
                      error.what());
      }
    }
    ~both() {
      ends = true;
      while (!runs.has_ended()) std::this_thread::sleep_for(rest);
    }
    both(const both&) = delete;
    both& operator=(const both&) = delete;

    void work() {
      while (!ends) {
        auto expected = turn::asked;
        if (!now.compare_exchange_strong(expected, turn::computes)) {
          std::this_thread::sleep_for(rest);
          continue;
        }
        try {
          result = Rule::batch(std::span<const example_type>(examples).first(count), settings);
          failed = false;
        } catch (...) { failed = true; }
        now.store(turn::done, std::memory_order_release);
      }
    }

    std::vector<example_type> examples;
    std::size_t count = 0;
    settings_type settings{};
    learned_type result{};
    bool failed = false;
    std::atomic<turn> now{turn::free};
    std::atomic<bool> ends{false};
    polled_thread runs{};
  };

  static constexpr std::chrono::milliseconds rest{1};

  void hand_over() {
    pending = true;
    beside->now.store(turn::asked, std::memory_order_release);
  }

  std::unique_ptr<both> beside;
  bool pending = false;  // a batch was asked for, and its result is wanted
};

}  // namespace cca::detail
