// EXPECT: bus\.overloaded: the bus `left` at 1000000 bit/s would be in use for 216 % of the time: 8 drives send 16 frames a cycle, which take up to 2160 us, at 1000 Hz
// A bus carries a limited number of bits a second, and stuff bits can make each frame longer. Eight drives
// that are asked and answer a thousand times a second do not fit on a classic bus of 1 Mbit/s.
#include <cca/hardware/bus_plan.hpp>
#include <cca/hardware/mit.hpp>

template <std::uint32_t Number>
using joint = cca::hardware::mit_drive<cca::hardware::ak80_9, Number>;

#if CCA_REJECT
struct left : cca::hardware::can_bus_plan<"left",
                                          cca::hardware::bit_rates{1'000'000},
                                          cca::rate<1000>,
                                          joint<1>,
                                          joint<2>,
                                          joint<3>,
                                          joint<4>,
                                          joint<5>,
                                          joint<6>,
                                          joint<7>,
                                          joint<8>> {};
#else
struct left : cca::hardware::can_bus_plan<"left",
                                          cca::hardware::bit_rates{1'000'000},
                                          cca::rate<400>,
                                          joint<1>,
                                          joint<2>,
                                          joint<3>,
                                          joint<4>,
                                          joint<5>,
                                          joint<6>,
                                          joint<7>,
                                          joint<8>> {};
#endif

double used = left::load;
