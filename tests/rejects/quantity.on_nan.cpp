// EXPECT: quantity\.on_nan: the quantity flow does not say what a limiter does with a command that is NaN: add `static constexpr auto on_nan = cca::nan_policy::hold;`
// A torque that is held goes on to accelerate, and an angle that goes to zero jumps: each quantity states
// what is safe.
#include "parts.hpp"

#if CCA_REJECT
struct flow {
  double lower, upper;
  static constexpr std::string_view unit = "m^3/s";
};
#else
struct flow {
  double lower, upper;
  static constexpr std::string_view unit = "m^3/s";
  static constexpr auto on_nan = cca::nan_policy::zero;
};
#endif

struct valve : cca::dimension<"valve"> {
  static constexpr auto limits = cca::limits{flow{0, 1}};
};
