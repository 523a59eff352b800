// EXPECT: drive\.duplicate_id: on the bus `0` the drives 1 \(left_front_hip\) and 2 \(left_front_knee\) both use the id 0x001
// A robot knows which drives share a bus: on one bus each drive has its own id; another bus may use the id
// again.
#include "oncilla.hpp"

#if CCA_REJECT
constexpr std::uint32_t knee = 1;
#else
constexpr std::uint32_t knee = 2;
#endif

struct a : joint<sim::left_front_hip, 1, 0> {};
struct b : joint<sim::right_front_hip, 1, 1> {};
struct c : joint<sim::left_hind_hip, 1, 2> {};
struct d : joint<sim::right_hind_hip, 1, 3> {};
struct e : joint<sim::left_front_knee, knee, 0> {};
struct f : joint<sim::right_front_knee, 2, 1> {};
struct g : joint<sim::left_hind_knee, 2, 2> {};
struct h : joint<sim::right_hind_knee, 2, 3> {};

struct robot : hw::oncilla<hw::memory_bus<>::end_type, a, b, c, d, e, f, g, h, board> {};
