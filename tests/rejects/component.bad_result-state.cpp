// EXPECT: component\.bad_result: the output `mode` holds numbers, and `mode` is an enumeration: write `cca::status_of\(\.\.\.\)` around its value
// A status is the number of a state.
#include "parts.hpp"

// Refused by a static_assert of the port's constructor, without a graph.

enum class mode { stand, walk };
struct mode_status : cca::space<cca::status, cca::axes<cca::x>> {};

struct behaviour {
  auto process(cca::beat) -> cca::out<"mode", mode_status> {
#if CCA_REJECT
    return mode::walk;
#else
    return cca::status_of(mode::walk);
#endif
  }
};
