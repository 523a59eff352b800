// How a run goes on that a fault or a pause holds: any thread asks the one that rests in
// cca::detail::held_run (runtime/live/held_run.hpp) to resume, or to start anew.
//
//   ask(what, is_paused)   any thread: why not, or empty: it is asked, and the resting thread takes it
//   how_it_went(k, is_faulted)
//                          any thread, after that: `nothing` as long as its first beat has not been made
//
// A fault that comes back in the first beat is a refusal: its cause is still there. Nobody waits here; the
// lock guards a text, and no beat takes it.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <utility>

namespace cca::detail {

class begun_anew {
public:
  enum class wish : std::uint8_t { nothing, resume, start };
  // `elsewhere`: no thread takes a wish. `stopped`: a start was refused.
  enum class place : std::uint8_t { elsewhere, waiting, running, faulted, stopped };
  struct answer {
    enum class kind : std::uint8_t { nothing, done, refused } is = kind::nothing;
    std::string why{};
  };

  // ---- any thread ----

  bool is_wanted() const noexcept { return wanted.load(std::memory_order_acquire) != wish::nothing; }
  bool is_wanted_to_start() const noexcept { return wanted.load(std::memory_order_acquire) == wish::start; }
  bool holds_fault() const noexcept { return at.load(std::memory_order_acquire) == place::faulted; }
  // Before its first beat, after a fault, after a refused start: there is no beat.
  bool rests() const noexcept {
    const place now = at.load(std::memory_order_acquire);
    return now != place::elsewhere && now != place::running;
  }

  // `is_paused`: the run is in a pause, in which a start begins anew.
  std::string ask(wish what, bool is_paused) {
    if (std::string why = why_not(what, is_paused); !why.empty()) return why;
    const std::scoped_lock lock(guard);
    refusal.clear();
    runs_then = runs.load(std::memory_order_acquire);
    wanted.store(what, std::memory_order_release);
    return {};
  }

  // `k`, `is_faulted`: the next beat and the state, as last seen. Read the beat first.
  answer how_it_went(std::int64_t k, bool is_faulted) const {
    using is = answer::kind;
    if (is_wanted()) return {};
    const std::scoped_lock lock(guard);
    if (!refusal.empty()) return {is::refused, refusal};
    if (runs.load(std::memory_order_acquire) == runs_then) return {is::refused, "the run has ended"};
    const place now = at.load(std::memory_order_acquire);
    if (now == place::running)
      return k > first.load(std::memory_order_acquire) && !is_faulted ? answer{is::done, {}} : answer{};
    if (!again.empty()) return {is::refused, again};
    return {is::done, {}};
  }

  // ---- the thread that runs the beats, at rest ----

  void is_at(place now) noexcept { at.store(now, std::memory_order_release); }
  // A run begins with the beat `k`.
  void begins(std::int64_t k) {
    const std::scoped_lock lock(guard);
    again.clear();
    first.store(k, std::memory_order_release);
    at.store(place::running, std::memory_order_release);
    runs.fetch_add(1, std::memory_order_acq_rel);
    wanted.store(wish::nothing, std::memory_order_release);
  }
  // A fault has ended a run; `k`: the next beat. `now`: whether it is held.
  void faults(std::int64_t k, const std::string& path, const std::string& reason, place now) {
    const std::scoped_lock lock(guard);
    if (k - first.load(std::memory_order_relaxed) <= 1)
      again = "it faults in its first beat: " + (path.empty() ? "" : "`" + path + "`: ") + reason;
    at.store(now, std::memory_order_release);
  }
  // What is wanted; it stays so until a run begins, or it is refused.
  wish taken() const noexcept { return wanted.load(std::memory_order_acquire); }
  void refuse(std::string why) {
    const std::scoped_lock lock(guard);
    refusal = std::move(why);
    wanted.store(wish::nothing, std::memory_order_release);
  }
  void ends() noexcept {
    at.store(place::elsewhere, std::memory_order_release);
    wanted.store(wish::nothing, std::memory_order_release);
  }

private:
  std::string why_not(wish what, bool is_paused) const {
    const place now = at.load(std::memory_order_acquire);
    const std::string name = what == wish::start ? "start: " : "resume: ";
    if (now == place::elsewhere)
      return name + "the program does it itself: after a fault it ends, unless it runs with --on-fault hold";
    if (is_wanted()) return name + "another one has not been done yet";
    if (what == wish::resume) {
      if (now == place::faulted) return {};
      if (now == place::running) return name + "nothing has faulted";
      return name + "nothing has faulted: `start` makes the first beat";
    }
    if (now == place::running && !is_paused)
      return name + "it runs already: after a pause, `start` begins anew";
    return {};
  }

  std::atomic<wish> wanted{wish::nothing};
  std::atomic<place> at{place::elsewhere};
  std::atomic<std::int64_t> first{0}, runs{0};
  mutable std::mutex guard{};
  std::int64_t runs_then = 0;
  std::string refusal{}, again{};
};

}  // namespace cca::detail
