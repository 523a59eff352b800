// The watchdog: checks the age of a command in each beat, and faults when it is stale.
//
//   cca::node<"watchdog", cca::watchdog<leg_angles, 5>>                               the oldest data
//   cca::node<"watchdog", cca::watchdog<leg_angles, 5, cca::of<"robot.angles">>>      one source
//
//   in  "command"   Space
//   out "fresh"     Space   maybe; the command as it came, with its origin
//   fault "stale command"   when the command is older than `Beats` beats
//   fault "stale source"    with `of`: when the newest sample of the source is older than `Beats` beats
//
// Without `of` the age is that of the oldest data from which the command was made: the time since the origin
// of the command or since its arrival, whichever is longer ago. So a slow input, as a goal that comes once a
// second, makes each command old. With `of` only the source counts, an output of this graph or of one around
// it: the time since its newest sample originated or arrived, whichever is longer ago. Whether the command
// comes at all is then not checked; put both watchdogs in a row for that.
//
// An origin in the future counts as its arrival. Before the first sample the age counts from the first beat.
// After a fault each resource node's `on_fault` runs in the same beat.
//
// It is a graph of one node with the clock `timed<1>`, because it must check even when nothing arrives.
// Errors: the faults above; wire.unknown_port, if nothing publishes the source. Cost: two comparisons.
// Example: tests/runtime/robot/watchdog.cpp; docs/robot.md.
#pragma once

#include <cstdint>
#include <tuple>

#include <cca/component/beat.hpp>
#include <cca/component/fault.hpp>
#include <cca/component/port.hpp>
#include <cca/graph/graph.hpp>

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

private:
  std::int64_t arrived = 0;
  bool begun = false;
};

template <class Space>
constexpr maybe<"fresh", Space> passed_on(const in<"command", Space>& command) {
  maybe<"fresh", Space> passed;
  if (command.origin() != never) passed = maybe<"fresh", Space>(command).with_origin(command.origin());
  return passed;
}

template <class Space, std::int64_t Beats>
class age_watch {
  static_assert(Beats >= 0, "cca::watchdog<Space, Beats>: Beats is the greatest age of a command");

public:
  static constexpr bool preserves_limits = true;

  auto process(in<"command", Space> command, beat now) -> std::tuple<maybe<"fresh", Space>, fault> {
    if (age.is_too_old(command.origin(), command.fresh(), Beats, now))
      return {maybe<"fresh", Space>(), fault("stale command")};
    return {passed_on(command), fault()};
  }

  void on_start() { age = {}; }

private:
  age_clock age;
};

template <class Space, std::int64_t Beats, fixed_string Source>
class source_watch {
  static_assert(Beats >= 0, "cca::watchdog<Space, Beats, of<...>>: Beats is the greatest age of the source");

public:
  static constexpr bool preserves_limits = true;

  auto process(in<"command", Space> command, observe<Source, one_output> source, beat now)
      -> std::tuple<maybe<"fresh", Space>, fault> {
    const observation& newest = *source.begin();
    if (age.is_too_old(newest.origin, newest.fresh, Beats, now))
      return {maybe<"fresh", Space>(), fault("stale source")};
    return {passed_on(command), fault()};
  }

  void on_start() { age = {}; }

private:
  age_clock age;
};

template <class Space, std::int64_t Beats, class Source>
struct watch_for;
template <class Space, std::int64_t Beats>
struct watch_for<Space, Beats, void> {
  using type = age_watch<Space, Beats>;
};
template <class Space, std::int64_t Beats, fixed_string Path>
struct watch_for<Space, Beats, of<Path>> {
  using type = source_watch<Space, Beats, Path>;
};

}  // namespace detail

template <class Space, std::int64_t Beats, class Source = void>
struct watchdog : graph<node<"watch", typename detail::watch_for<Space, Beats, Source>::type, timed<1>>,
                        expose<"watch.command", "command">,
                        expose<"watch.fresh", "fresh">> {};

}  // namespace cca
