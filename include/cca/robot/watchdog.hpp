// The watchdog: checks the age of a command in each beat, and faults when it is stale.
//
//   cca::node<"watchdog", cca::watchdog<leg_angles, 5>>                               the oldest data
//   cca::node<"watchdog", cca::watchdog<leg_angles, 5, cca::of<"robot.angles">>>      one source
//   cca::node<"watchdog", cca::watchdog<leg_angles, 5, cca::of<"robot.angles">, 20>>  and slower commands
//
//   in  "command"   Space
//   out "fresh"     Space   maybe; the command as it came, with its origin
//   fault "stale command"   when the command is older than `Beats` beats
//   with `of`:
//   fault "stale source"    when the newest sample of the source is older than `Beats` beats
//   fault "stale command"   when no command has arrived for `Arrival` beats; without a number, for `Beats`
//   cause()                 after the fault: how old it is, and how old it may be
//
// Without `of` the age is that of the oldest data from which the command was made: the time since the origin
// of the command or since its arrival, whichever is longer ago. So a slow input, as a goal that comes once a
// second, makes each command old. With `of` the age is that of the source, an output of this graph or of one
// around it: the time since its newest sample originated or arrived, whichever is longer ago. Of the command
// only the arrival counts then, not its origin.
//
// An origin in the future counts as its arrival. Before the first sample the age counts from the first beat.
// After a fault each resource node's `on_fault` runs in the same beat.
//
// It is a graph of one node with the clock `timed<1>`, because it must check even when nothing arrives.
// Errors: the faults above; wire.unknown_port, if nothing publishes the source. Cost: two comparisons.
// Example: tests/runtime/robot/watchdog.cpp; docs/robot.md.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>

#include <cca/space/messages/space_in_words.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/after_run.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/fault.hpp>
#include <cca/component/port.hpp>
#include <cca/graph/items/graph.hpp>

namespace cca {

// An output, by its path: `node.port`.
template <fixed_string Path>
struct of {};

namespace detail {

// The age of what arrives, in time since its origin or its arrival.
class age_clock {
public:
  bool is_too_old(std::int64_t origin, bool fresh, std::int64_t beats, const beat& now) {
    if (fresh || !begun) arrived = now.time();
    begun = true;
    const std::int64_t period = static_cast<std::int64_t>(now.dt() * 1e9 + 0.5);
    return now.time() - older(origin, arrived) > beats * period;
  }
  // How old it is, in a beat that found it too old. `has_come`: there was one at all.
  void note(std::int64_t origin, std::int64_t beats, const beat& now, bool has_come) {
    found = {1e-9 * static_cast<double>(now.time() - older(origin, arrived)),
             static_cast<double>(beats) * now.dt(), now.index(), has_come};
  }
  // "the command is 0.006 s old, 0.005 s are allowed", or "no command has come for 0.006 s, ..."
  cca::cause told(const std::string& what, const std::string& none, const char* remedy) const {
    if (found.beat < 0) return {};
    const std::string text = found.has_come ? what + formatted(" is %.4g s old", found.age)
                                            : "no " + none + formatted(" has come for %.4g s", found.age);
    return {text + formatted(", %.4g s are allowed: ", found.allowed) + remedy, found.beat};
  }
  // By its arrival only.
  bool is_too_old(bool fresh, std::int64_t beats, const beat& now) {
    return is_too_old(now.time(), fresh, beats, now);
  }

private:
  struct {
    double age = 0, allowed = 0;  // s
    std::int64_t beat = -1;
    bool has_come = false;
  } found{};
  std::int64_t arrived = 0;
  bool begun = false;
};

template <class Space>
constexpr maybe<"fresh", Space> passed_on(const in<"command", Space>& command) {
  maybe<"fresh", Space> passed;
  if (command.origin() != never) passed = maybe<"fresh", Space>(command).with_origin(command.origin());
  return passed;
}

enum class watch_time : std::uint8_t { command, source, arrival };

template <class Space, std::int64_t Beats, watch_time What>
struct bad_watch_time {
  static constexpr void tell(text& m) {
    constexpr const char* names[] = {"the greatest age of a command", "the greatest age of the source",
                                     "the longest time without a command"};
    m << "cca::watchdog: " << names[static_cast<int>(What)] << ", in beats, is " << Beats
      << " in the watchdog of " << space_in_words<Space>() << ": make it 0 or more";
  }
};
template <class Space, std::int64_t Beats, std::int64_t Arrival>
struct arrival_without_source {
  static constexpr void tell(text& m) {
    m << "cca::watchdog: the watchdog of " << space_in_words<Space>() << " waits " << Beats
      << " beats for the data and " << Arrival
      << " for a command, but has no source of data: name one, as in `cca::of<path>`, or leave out the "
         "second";
  }
};

template <class Space, std::int64_t Beats>
class age_watch {
  static_assert(holds_or_tells<(Beats >= 0), bad_watch_time<Space, Beats, watch_time::command>>::value);

public:
  static constexpr bool preserves_limits = true;

  auto process(in<"command", Space> command, beat now) -> std::tuple<maybe<"fresh", Space>, fault> {
    if (age.is_too_old(command.origin(), command.fresh(), Beats, now)) {
      age.note(command.origin(), Beats, now, command.origin() != never);
      return {maybe<"fresh", Space>(), fault("stale command")};
    }
    return {passed_on(command), fault()};
  }

  cca::cause cause() const {
    return age.told("the oldest data of the command", "command",
                    "see what its writers wait for, or raise `Beats`");
  }
  void on_start() { age = {}; }

private:
  age_clock age;
};

template <class Space, std::int64_t Beats, fixed_string Source, std::int64_t Arrival>
class source_watch {
  static_assert(holds_or_tells<(Beats >= 0), bad_watch_time<Space, Beats, watch_time::source>>::value);
  static_assert(holds_or_tells<(Arrival >= 0), bad_watch_time<Space, Arrival, watch_time::arrival>>::value);

public:
  static constexpr bool preserves_limits = true;

  auto process(in<"command", Space> command, observe<Source, one_output> source, beat now)
      -> std::tuple<maybe<"fresh", Space>, fault> {
    const observation& newest = *source.begin();
    const bool no_source = of_source.is_too_old(newest.origin, newest.fresh, Beats, now);
    const bool no_command = of_command.is_too_old(command.fresh(), Arrival, now);
    if (no_source) {
      of_source.note(newest.origin, Beats, now, newest.origin != never);
      return {maybe<"fresh", Space>(), fault("stale source")};
    }
    if (no_command) {
      of_command.note(now.time(), Arrival, now, command.origin() != never);
      return {maybe<"fresh", Space>(), fault("stale command")};
    }
    return {passed_on(command), fault()};
  }

  cca::cause cause() const {
    const std::string source = "sample of `" + std::string(Source.view()) + "`";
    if (const cca::cause old = of_source.told("the newest " + source, source,
                                              "see why it is no longer published, or raise `Beats`"))
      return old;
    return of_command.told("the command", "command", "see what its writer waits for, or raise `Arrival`");
  }
  void on_start() { of_source = of_command = {}; }

private:
  age_clock of_source, of_command;
};

template <class Space, std::int64_t Beats, class Source, std::int64_t Arrival>
struct watch_for;
template <class Space, std::int64_t Beats, std::int64_t Arrival>
struct watch_for<Space, Beats, void, Arrival> {
  static_assert(holds_or_tells<(Arrival == Beats), arrival_without_source<Space, Beats, Arrival>>::value);
  using type = age_watch<Space, Beats>;
};
template <class Space, std::int64_t Beats, fixed_string Path, std::int64_t Arrival>
struct watch_for<Space, Beats, of<Path>, Arrival> {
  using type = source_watch<Space, Beats, Path, Arrival>;
};

}  // namespace detail

template <class Space, std::int64_t Beats, class Source = void, std::int64_t Arrival = Beats>
struct watchdog
    : graph<node<"watch", typename detail::watch_for<Space, Beats, Source, Arrival>::type, timed<1>>,
            expose<"watch.command", "command">,
            expose<"watch.fresh", "fresh">> {};

}  // namespace cca
