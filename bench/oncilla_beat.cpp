// The beat of the trot with the simulated robot, whose hip, knee and trunk nodes, splitter and collectors
// leave nothing in it but the simulator: what `calls.py` disassembles.
#include "../examples/trot/rollout.hpp"

void beat(trot::trotting& c) { c.step(); }
