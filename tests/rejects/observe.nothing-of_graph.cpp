// EXPECT: observe\.nothing: cca::observe<`gpc\.\*`> in walk names nothing, neither in walk nor in a graph around it, so it would hear nothing; did you mean `cpg\.\*`\?
// So does what a graph observes for programs.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"cpg", oscillator>,
#if CCA_REJECT
                         cca::observe<"gpc.*">
#else
                         cca::observe<"cpg.*">
#endif
                         > {
};

cca::controller<walk> c;
