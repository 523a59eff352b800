// EXPECT: beat\.not_whole: the third number of this beat is no whole number: a beat is made of its index, its period in nanoseconds and the number of beats since the component last fired
// A test that calls a component itself makes the beat: the third number counts beats, it is not a time.
#include "parts.hpp"

#if CCA_REJECT
const cca::beat now(3, 1'000'000, 0.001);
#else
const cca::beat now(3, 1'000'000, 1);
#endif

auto phase() { return oscillator().process(now); }
