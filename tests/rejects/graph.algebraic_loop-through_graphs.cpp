// EXPECT: graph\.algebraic_loop: `inner\.a\.angles` -> `inner\.b\.angles`, `inner\.b\.angles` -> `outer\.angles`, `outer\.angles` -> `inner\.a\.angles` are a loop without
// The loop is found through inner graphs too.
#include "parts.hpp"

struct filter : cca::graph<cca::node<"a", posture>,
                           cca::node<"b", posture>,
                           cca::wire<"a.angles", "b.angles">,
                           cca::expose<"a.angles", "in">,
                           cca::expose<"b.angles", "out">> {};

struct robot : cca::graph<cca::rate<1000>,
                          cca::node<"inner", filter>,
                          cca::node<"outer", posture>,
                          cca::wire<"inner.out", "outer.angles">,
#if CCA_REJECT
                          cca::wire<"outer.angles", "inner.in">
#else
                          cca::wire<"outer.angles", "inner.in", cca::delayed<1>>
#endif
                          > {
};

cca::controller<robot> c;
