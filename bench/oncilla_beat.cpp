// The beat of the trot with the simulated robot, for `calls.py` to disassemble. Of the nodes of the
// robot's joints, its splitters and collectors only calls of the simulator may be left.
#include "../examples/trot/rollout.hpp"

void beat(trot::trotting& c) { c.step(); }
