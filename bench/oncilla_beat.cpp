// The beat of the trot with the simulated robot, for `calls.py` to disassemble. Of the robot's hip, knee and
// trunk nodes, splitter and collectors only calls of the simulator may be left.
#include "../examples/trot/rollout.hpp"

void beat(trot::trotting& c) { c.step(); }
