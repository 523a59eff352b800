// The watchdog: watches the age of a command and faults when it is stale.
//
//   cca::node<"watchdog", cca::watchdog<leg_angles, 5>, cca::timed<1>>      in "command"; out "fresh"
//
// The age is the beat's time less the command's origin, so it is the age of the data that the command was made from, not
// of the message. A command older than `Beats` beats is not passed on, and the component faults: every resource node's
// `on_fault` runs in the same beat. Before a first command has come the age counts from the first beat of the watchdog.
// It keeps what it lets through as it was, origin included. Errors: the fault `stale command`.
#pragma once

#include <cstdint>
#include <tuple>

#include <cca/component/beat.hpp>
#include <cca/component/fault.hpp>
#include <cca/component/port.hpp>

namespace cca {

template <class Space, std::int64_t Beats>
class watchdog {
  static_assert(Beats >= 0, "cca::watchdog<Space, Beats>: Beats is the greatest age of a command");

public:
  static constexpr bool preserves_limits = true;

  auto process(in<"command", Space> command, beat now) -> std::tuple<maybe<"fresh", Space>, fault> {
    if (since < 0) since = now.time();
    const std::int64_t from = command.origin() == never ? since : command.origin();
    const std::int64_t period = now.index() > 0 ? now.time() / now.index() : 0;
    if (now.time() - from > Beats * period) return {{}, fault("stale command")};
    if (command.origin() == never) return {};
    return {maybe<"fresh", Space>(command).with_origin(command.origin()), {}};
  }

  void on_start() { since = -1; }

private:
  std::int64_t since = -1;
};

}  // namespace cca
