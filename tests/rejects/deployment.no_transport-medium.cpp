// EXPECT: deployment\.no_transport: the second argument of cca::deployed<[a-zA-Z]+>, `[a-z_]+`, is no transport
// What `open` returns is a medium: it is derived from `cca::peers`, and `exchanged()` points to a
// `cca::exchange<D>`.
#include "two_places.hpp"

struct split : cca::deployment<walk,
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
                               cca::environment<"log", cca::other_nodes>> {};

template <class D>
#if CCA_REJECT
struct cabled {
  cca::exchange<D>* exchanged() { return &all; }
  cca::exchange<D> all;
};
#else
struct cabled : cca::peers {
  cca::exchange<D>* exchanged() { return &all; }
  bool is_gone(int) const override { return false; }
  cca::exchange<D> all;
};
#endif
struct by_cable {
  template <class D>
  std::shared_ptr<cabled<D>> open(const cca::environments_here<D>&) const {
    return std::make_shared<cabled<D>>();
  }
};

cca::deployed<split> d(cca::only{"control"}, by_cable{});
