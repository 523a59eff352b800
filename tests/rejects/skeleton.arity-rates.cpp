// EXPECT: skeleton\.arity: `slow` \(decimate<.*>\) leads from fast_angles \(1000 Hz\) to slow_angles \(300 Hz\), but the first must have a rate that is a whole multiple of that of the second
// 1000 Hz is no multiple of 300 Hz.
#include "parts.hpp"

struct fast_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};
#if CCA_REJECT
struct slow_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<300>> {};
#else
struct slow_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<250>> {};
#endif

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"slow", cca::decimate<fast_angles, slow_angles>>,
                         cca::node<"recorder", recorder>,
                         cca::wire<"stance.angles", "slow.input">,
                         cca::wire<"slow.output", "recorder.angles">> {};

cca::controller<walk> c;
