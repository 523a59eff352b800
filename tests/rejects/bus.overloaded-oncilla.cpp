// EXPECT: bus\.overloaded: the bus `0` at 1000000 bit/s would be in use for 108 % of the time: 4 drives send 8 frames a cycle, which take up to 1080 us, at 1000 Hz
// A robot knows which drives share a bus: four drives that are asked and answer are too many for a classic
// bus at 1 kHz.
#include "oncilla.hpp"

#if CCA_REJECT
constexpr std::size_t fore = 0, hind = 0, right_hip = 1;
#else
constexpr std::size_t fore = 0, hind = 1, right_hip = 2;
#endif

struct a : joint<sim::left_front_hip, 1, fore> {};
struct b : joint<sim::right_front_hip, 2, right_hip> {};
struct c : joint<sim::left_hind_hip, 3, hind> {};
struct d : joint<sim::right_hind_hip, 4, 3> {};
struct e : joint<sim::left_front_knee, 5, fore> {};
struct f : joint<sim::right_front_knee, 6, 2> {};
struct g : joint<sim::left_hind_knee, 7, hind> {};
struct h : joint<sim::right_hind_knee, 8, 3> {};

struct robot : hw::oncilla<hw::memory_bus<>::end_type, a, b, c, d, e, f, g, h, board> {};
