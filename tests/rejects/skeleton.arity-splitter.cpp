// EXPECT: skeleton\.arity: `split` \(splitter<.*>\) is to take attitude apart, which has 4 numbers over 3 axes, so none of them belongs to one axis
// A quaternion has no number for each axis.
#include "parts.hpp"

struct world : cca::frame<"world"> {};
using xyz = cca::axes<cca::x, cca::y, cca::z>;
struct attitude : cca::space<cca::orientation<world>, xyz> {};
struct place : cca::space<cca::cartesian_position<world>, xyz> {};
#if CCA_REJECT
using measured = attitude;
#else
using measured = place;
#endif

struct trunk {
  auto process(cca::beat) -> cca::out<"trunk", measured> { return {}; }
};

struct walk : cca::graph<
    cca::rate<1000>,
    cca::node<"trunk", trunk>,
    cca::node<"split", cca::splitter<"trunk", measured>>,
    cca::wire<"trunk.trunk", "split.trunk">> {};

cca::controller<walk> c;
