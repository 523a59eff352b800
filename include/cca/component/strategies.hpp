// All strategies of the library. What every one of them must have (a random test, a row in
// docs/strategies.md) is checked over this list: tests/semantics/every_strategy.cpp.
#pragma once

#include <cca/component/strategies/all_of.hpp>
#include <cca/component/strategies/any_of.hpp>
#include <cca/component/strategies/coordinated.hpp>
#include <cca/component/strategies/full_speed.hpp>
#include <cca/component/strategies/inactive.hpp>
#include <cca/component/strategies/moderate.hpp>
#include <cca/component/strategies/port_triggered.hpp>
#include <cca/component/strategies/restless.hpp>
#include <cca/component/strategies/stoppable.hpp>
#include <cca/component/strategies/timed.hpp>
#include <cca/component/strategies/timeout.hpp>

namespace cca::detail {

// One of each, with the least arguments.
using library_strategies = list<timed<1>,
                                restless,
                                moderate,
                                port_triggered<>,
                                coordinated,
                                timeout<1>,
                                full_speed,
                                inactive,
                                any_of<>,
                                all_of<>,
                                stoppable<restless>>;

}  // namespace cca::detail
