// EXPECT: robot\.description: pendulum floats, but the base of its body has no mass; add `static constexpr cca::link_inertia base
// A base that nothing holds moves by the forces on it.
#include "pendulum.hpp"

struct pendulum : described<> {
  struct body : cca::body<mount, cca::part<"arm", chain_of_one>> {
#if !CCA_REJECT
    static constexpr cca::link_inertia base{5, {0, 0, 0}, {0.1, 0.1, 0.1, 0, 0, 0}};
#endif
  };
  static constexpr bool floats = true;
};

static_assert(cca::robots::check_description<pendulum>());
