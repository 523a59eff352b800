// EXPECT: modes\.bad_mode: mode `walk` of legs is a deployment, whose environments would be ignored: give its architecture instead, walk
// All modes of a set run in one loop: their graphs are no deployments.
#include <cca/deployment.hpp>
#include <cca/modes.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>, cca::node<"oscillator", oscillator>, cca::node<"log", logbook>> {};
struct rest : cca::graph<cca::rate<1000>, cca::node<"stance", stance>, cca::node<"log", logbook>> {};
struct deployed_walk : cca::deployment<walk, cca::environment<"all", cca::other_nodes>> {};

struct legs : cca::modes<
#if CCA_REJECT
                  cca::mode<"walk", deployed_walk>,
#else
                  cca::mode<"walk", walk>,
#endif
                  cca::mode<"rest", rest>> {
};

cca::controller<legs> c;
