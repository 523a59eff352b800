// EXPECT: skeleton\.arity: `held` \(hold<.*>\) leads from slow_angles \(100 Hz\) to fast_angles \(1000 Hz\), which differ in more than their rate: name two spaces of one domain type over the same axes
// A hold changes the rate, and nothing else.
#include "parts.hpp"

struct slow_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<100>> {};
#if CCA_REJECT
struct fast_angles : cca::space<cca::joint_angles, cca::axes<hip>, cca::rate<1000>> {};
#else
struct fast_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};
#endif

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"stance", stance, cca::timed<10>>,
                         cca::node<"held", cca::hold<slow_angles, fast_angles>, cca::timed<1>>,
                         cca::wire<"stance.angles", "held.input", cca::latest>> {};

cca::controller<walk> c;
