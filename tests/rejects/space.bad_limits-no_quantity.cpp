// EXPECT: space\.bad_limits: a `cca::limits` lists `double`, which is no quantity: give each range its quantity, as in `cca::limits\{cca::angle\{-0\.5, 0\.5\}, cca::torque\{-3, 3\}\}`
// LINES: 15
// Each range in a cca::limits is that of a quantity, and each quantity has one.
#include "parts.hpp"

// Refused where the limits stand, without a graph.

struct toe : cca::dimension<"toe"> {
#if CCA_REJECT
  static constexpr auto limits = cca::limits{-0.5, 0.5};
#else
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}};
#endif
};
