// EXPECT: robot\.description: the cable `line_springs\[0\]` of pendulum ends on the part `hand`, which its body lacks: it has `arm`
// A cable pulls at points of parts, which it finds by the names of the parts.
#include "pendulum.hpp"

struct pendulum : described<> {
#if CCA_REJECT
  static constexpr std::array line_springs{cca::robots::cable(
      cca::robots::point_on_base({0, 0, 0.2}), cca::robots::point_at_tip("hand"), 4000, 0.3)};
#else
  static constexpr std::array line_springs{cca::robots::cable(
      cca::robots::point_on_base({0, 0, 0.2}), cca::robots::point_at_tip("arm"), 4000, 0.3)};
#endif
};

static_assert(cca::robots::check_description<pendulum>());
