// EXPECT: skeleton\.arity: `smooth` \(interpolate<.*>\) leads from slow_angles \(300 Hz\) to fast_angles \(1000 Hz\), but the first must have a rate that is a whole part of that of the second
// There is no whole number of steps from one sample to the next.
#include "parts.hpp"

#if CCA_REJECT
struct slow_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<300>> {};
#else
struct slow_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<250>> {};
#endif
struct fast_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"stance", stance, cca::timed<4>>,
                         cca::node<"smooth", cca::interpolate<slow_angles, fast_angles>, cca::timed<1>>,
                         cca::wire<"stance.angles", "smooth.input", cca::latest>> {};

cca::controller<walk> c;
