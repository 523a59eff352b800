// The watchdog: checks the age of a command in each beat, and faults when it is stale.
//
//   cca::node<"watchdog", cca::watchdog<leg_angles, 5>>
//
//   in  "command"   Space
//   out "fresh"     Space   maybe; the command as it came, with its origin
//   fault "stale command"   when the command is older than `Beats` beats
//
// The age is the time since the origin of the command or since its arrival, whichever is longer ago. So a
// command with an origin in the future becomes stale too. Before the first command the age counts from the
// first beat. After a fault each resource node's `on_fault` runs in the same beat.
//
// It is a graph of one node with the clock `timed<1>`, because it must check even when nothing arrives.
// Errors: the fault `stale command`. Cost: two comparisons. Example: tests/runtime/robot/watchdog.cpp;
// docs/robot.md.
#pragma once

#include <cstdint>
#include <tuple>

#include <cca/component/beat.hpp>
#include <cca/component/fault.hpp>
#include <cca/component/port.hpp>
#include <cca/graph/graph.hpp>

namespace cca {
namespace detail {

template <class Space, std::int64_t Beats>
class age_watch {
  static_assert(Beats >= 0, "cca::watchdog<Space, Beats>: Beats is the greatest age of a command");

public:
  static constexpr bool preserves_limits = true;

  auto process(in<"command", Space> command, beat now) -> std::tuple<maybe<"fresh", Space>, fault> {
    if (command.fresh() || !begun) arrived = now.time();
    begun = true;
    const std::int64_t period = static_cast<std::int64_t>(now.dt() * 1e9 + 0.5);
    const std::int64_t from = older(command.origin(), arrived);
    maybe<"fresh", Space> passed;
    if (now.time() - from > Beats * period) return {passed, fault("stale command")};
    if (command.origin() != never) passed = maybe<"fresh", Space>(command).with_origin(command.origin());
    return {passed, fault()};
  }

  void on_start() { begun = false; }

private:
  std::int64_t arrived = 0;
  bool begun = false;
};

}  // namespace detail

template <class Space, std::int64_t Beats>
struct watchdog : graph<node<"watch", detail::age_watch<Space, Beats>, timed<1>>,
                        expose<"watch.command", "command">,
                        expose<"watch.fresh", "fresh">> {};

}  // namespace cca
