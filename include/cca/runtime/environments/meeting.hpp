// How environments begin a run together and end it together, whichever process they are in. Each writes what
// it wants into its record, and the number of the run when it is there.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

#include <cca/base/separate/function_ref.hpp>
#include <cca/base/refused.hpp>
#include <cca/runtime/environments/exchange/exchange.hpp>
#include <cca/runtime/environments/waiting/idle_beats.hpp>
#include <cca/runtime/environments/exchange/peers.hpp>

namespace cca::detail {

// What all agree on.
struct terms_of_run {
  std::int64_t beat = 0, end = no_position;
  bool is_exact = true;       // the first environment's
  bool all_meet = false;      // after each beat, because somebody wants to
  bool is_stopped = false;    // there is no run: another process has called stop()
  std::int64_t stops = 0;     // how often this process has called it since the last run
  bool is_off = false;        // there is no run: this process does not want it any more
  int mode = 0;               // of a set of modes: with which it begins
  std::int64_t switches = 0;  // and how many there have been
};

template <class D>
class meeting {
public:
  meeting(exchange<D>& exchanged, const environments_here<D>& is_here, const peers* others)
      : shared(exchanged), here(is_here), away(others) {
    for (const auto& e : shared.environments) run = std::max<std::int64_t>(run, e.finished);
    ++run;
  }

  // Waits for all environments, at most so long. While anything here waits, `meanwhile()` is called once a
  // period.
  terms_of_run agree(const terms_of_run& wanted,
                     std::int64_t beats,
                     std::int64_t longest,
                     idle_beats& idle,
                     function_ref<void()> meanwhile,
                     function_ref<bool()> goes_on) {
    terms_of_run agreed;
    for (bool is_newest = false; !is_newest;) {
      for_each_here([&](auto& own) {
        own.beat = wanted.beat;
        own.length = beats;
        own.is_exact = wanted.is_exact;
        own.all_meet = wanted.all_meet;
        if constexpr (DeploymentOfModes<D>) {
          auto& modes = shared.modes[static_cast<std::size_t>(&own - shared.environments.data())];
          modes.mode = wanted.mode;
          modes.switches = wanted.switches;
        }
        own.arrived.store(run, std::memory_order_release);
      });
      check();
      wait(&record::arrived, idle, meanwhile, [&](std::size_t missing, std::int64_t waited) {
        if (agreed.is_stopped || agreed.is_off) return false;
        check();
        agreed.is_off = !goes_on();
        // Its start() may not have come yet: a stop() that this process has called, too, is over.
        agreed.is_stopped =
            shared.environments[missing].stopped.load(std::memory_order_acquire) > wanted.stops;
        if (!agreed.is_stopped && !agreed.is_off && waited < longest) return true;
        withdraw();
        if (agreed.is_stopped || agreed.is_off) return false;
        throw refused("cca::deployed: environment " + named(missing) + " has not begun to run within " +
                      seconds(longest) + ": start the process that runs it");
      });
      if (agreed.is_stopped || agreed.is_off) return agreed;
      const std::int64_t before = away ? away->newest_run_before() : 0;
      is_newest = before < run;
      run = std::max(run, before + 1);
    }
    agreed.is_exact = shared.environments[0].is_exact;
    agreed.end = no_position / exchange<D>::calls_and_one - 1;  // its position is still a number
    for (const auto& e : shared.environments) {
      agreed.beat = std::max<std::int64_t>(agreed.beat, e.beat);
      agreed.all_meet = agreed.all_meet || e.all_meet;
    }
    if constexpr (DeploymentOfModes<D>) {
      agreed.switches = -1;
      for (const auto& e : shared.modes)
        if (e.switches > agreed.switches) {
          agreed.switches = e.switches;
          agreed.mode = static_cast<int>(e.mode);
        }
    }
    for (const auto& e : shared.environments)
      if (e.length < no_position - agreed.beat)
        agreed.end = std::min<std::int64_t>(agreed.end, agreed.beat + e.length);
    // What the run is, for a transport: a follower may have wished for another one.
    for_each_here([&](auto& own) {
      own.is_exact = agreed.is_exact;
      own.all_meet = agreed.all_meet;
    });
    return agreed;
  }

  // Everybody is prepared for a run that begins with this beat: from here on they look at each other's
  // positions. Waits at most so long for a process that stands still since it has called `run`. If that goes
  // on later, its run ends before its first beat.
  void begin(std::int64_t beat, std::int64_t longest, idle_beats& idle, function_ref<void()> meanwhile) {
    for_each_here([&](auto& own) { own.ready.store(run, std::memory_order_release); });
    wait(&record::ready, idle, meanwhile, [&](std::size_t missing, std::int64_t waited) {
      if (waited < longest) return is_with_us(missing);
      for_each_here([&](auto& own) {
        own.beat = beat;
        own.stop_at.store(beat, std::memory_order_release);
        own.finished.store(run, std::memory_order_release);
      });
      withdraw();
      throw refused("cca::deployed: environment " + named(missing) +
                    " has called run, but has not begun it within " + seconds(longest) +
                    ": its process stands still (SIGSTOP, a debugger): let it go on, or end it");
    });
  }

  // Nobody looks any more. The beat with which they go on.
  std::int64_t end(std::int64_t beat, idle_beats& idle, function_ref<void()> meanwhile) {
    for_each_here([&](auto& own) {
      own.beat = beat;
      own.finished.store(run, std::memory_order_release);
    });
    wait(&record::finished, idle, meanwhile, [&](std::size_t e, std::int64_t) { return is_with_us(e); });
    std::int64_t next = beat;
    for (const auto& e : shared.environments)
      if (e.finished.load(std::memory_order_acquire) >= run) next = std::max<std::int64_t>(next, e.beat);
    return next;
  }

private:
  using record = environment_record<environment_count<D>>;

  template <class F>
  void for_each_here(F f) {
    for (std::size_t e = 0; e < here.size(); ++e)
      if (here[e]) f(shared.environments[e]);
  }

  static std::string named(std::size_t e) { return "`" + std::string(environments_of<D>::all[e].name) + "`"; }
  static std::string seconds(std::int64_t ns) { return std::to_string(ns / 1'000'000'000) + " s"; }

  void withdraw() {
    for_each_here([](auto& own) { own.arrived = 0; });
  }
  void check() {
    if (!away) return;
    try {
      away->check();
    } catch (...) {
      withdraw();
      throw;
    }
  }

  // It has not withdrawn, and its process is there.
  bool is_with_us(std::size_t e) const {
    return shared.environments[e].arrived.load(std::memory_order_acquire) >= run &&
           !(away && away->is_gone(static_cast<int>(e)));
  }

  // Waits until each environment is at this run. Ends early if waits(missing, ns), called now and then,
  // returns false.
  void wait(std::atomic<std::int64_t> record::* at,
            idle_beats& idle,
            function_ref<void()> meanwhile,
            function_ref<bool(std::size_t, std::int64_t)> waits) {
    const std::int64_t since = monotonic_clock::now();
    for (std::size_t e = 0; e < here.size(); ++e)
      idle.until(
          [&](patience& waiting) {
            return (shared.environments[e].*at).load(std::memory_order_acquire) >= run ||
                   (waiting.is_time_to_ask() && !waits(e, monotonic_clock::now() - since));
          },
          meanwhile);
  }

  exchange<D>& shared;
  const environments_here<D>& here;
  const peers* away;
  std::int64_t run = 0;
};

}  // namespace cca::detail
