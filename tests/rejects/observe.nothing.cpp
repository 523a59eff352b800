// EXPECT: observe\.nothing: `mind\.log` \(log_of<.*>\) observes `gait\.\*`, which names nothing in mind or in a graph around it, so it would hear nothing; did you mean `gait\.\*\*`\?
// A pattern names something: `*` is one name, `**` any number of names, and dots join them. It is looked up
// in the graph of the component, then in the graphs around it; with a `/` in front in the outermost one. The
// same holds for what a graph observes for programs, and for the source of a watchdog.
#include "parts.hpp"

template <class Heard>
struct log_of {
  void process(Heard) {}
};

struct mind : cca::graph<
#if CCA_REJECT
                  cca::node<"log", log_of<cca::observe<"gait.*">>>
#else
                  cca::node<"log", log_of<cca::observe<"gait.**">>>
#endif
                  > {
};

struct walking : cca::graph<cca::node<"cpg", oscillator>,
                            cca::node<"shape", gait>,
                            cca::wire<"cpg.phase", "shape.phase">> {};

struct walk : cca::graph<cca::rate<1000>, cca::node<"gait", walking>, cca::node<"mind", mind>> {};

cca::controller<walk> c;
