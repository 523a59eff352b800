// EXPECT: rate\.mismatch: the inner graph `walking` \(walking\) states 500 Hz, but robot runs at 1000 Hz: give both one rate, or let the inner one state none
// A whole architecture runs in one beat: an inner graph may state its rate, but no other.
#include "parts.hpp"

#if CCA_REJECT
struct walking : cca::graph<cca::rate<500>, cca::node<"stance", stance>> {};
#else
struct walking : cca::graph<cca::rate<1000>, cca::node<"stance", stance>> {};
#endif
struct robot : cca::graph<cca::rate<1000>, cca::node<"log", logbook>, cca::node<"walking", walking>> {};

cca::controller<robot> c;
