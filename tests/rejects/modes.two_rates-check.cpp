// EXPECT: modes\.two_rates: .*500
// LINES: 15
// cca::check takes sets of modes too.
#include <cca/modes.hpp>

#include "parts.hpp"

// A diagnosis does not tell how often the compiler says it.

struct standing : cca::graph<cca::rate<1000>, cca::node<"stance", stance>, cca::node<"log", logbook>> {};
#if CCA_REJECT
struct walking : cca::graph<cca::rate<500>, cca::node<"stance", stance>, cca::node<"log", logbook>> {};
#else
struct walking : cca::graph<cca::rate<1000>, cca::node<"stance", stance>, cca::node<"log", logbook>> {};
#endif
struct motions : cca::modes<cca::mode<"standing", standing>, cca::mode<"walking", walking>> {};

static_assert(cca::check<motions>());

cca::controller<motions> c;
