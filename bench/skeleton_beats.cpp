// The beat of each skeleton's graph, for `calls.py` to disassemble.
#include "skeletons.hpp"

void beat(cca::controller<bench::splitter_collector>& c) { c.step(); }
void beat(cca::controller<bench::pipeline>& c) { c.step(); }
void beat(cca::controller<bench::pipeline_delayed>& c) { c.step(); }
void beat(cca::controller<bench::farm>& c) { c.step(); }
void beat(cca::controller<bench::farm_threads>& c) { c.step(); }
void beat(cca::controller<bench::by_priority>& c) { c.step(); }
void beat(cca::controller<bench::by_freshness>& c) { c.step(); }
void beat(cca::controller<bench::switched>& c) { c.step(); }
void beat(cca::controller<bench::blended>& c) { c.step(); }
void beat(cca::controller<bench::held>& c) { c.step(); }
void beat(cca::controller<bench::decimated>& c) { c.step(); }
void beat(cca::controller<bench::averaged>& c) { c.step(); }
void beat(cca::controller<bench::interpolated>& c) { c.step(); }
