// EXPECT two_rates: cca::hardware::robot_buses: `shoulder` \(1000000 and 5000000 bit/s\) and `elbow` \(500000 and 0 bit/s\) are on bus 0, and a bus has one rate
// EXPECT too_many_buses: robot\.drives: 2 buses are connected, and the joints and the board of this robot are on 1: give one for each number from 0 to 0; on the last is `shoulder`, `elbow`
// EXPECT other_bus: robot\.drives: bus 0 that is connected is of the type memory_bus<3[^>]*>, and the buses of this robot are of the type end_type, which stands before its joints: connect such a bus
// EXPECT unused_bus: robot\.drives: nothing of this robot is on bus 1, but `elbow` is on bus 2: the number of a bus is its place in `connect\(bus0, bus1, \.\.\.\)`, so count them from 0 without a gap
// EXPECT first_unused: robot\.drives: nothing of this robot is on bus 0, but `shoulder` is on bus 1
// EXPECT ids_of_board: drive\.bad_number: a board of 2 frames with the first id 2047 has the ids up to 2048, and the last of 11 bits is 2047
// EXPECT no_sensor: drive\.bad_number: the board at the id 256 has no sensor, so it would send nothing
// EXPECT ids_of_oncilla: drive\.bad_number: a board of 6 frames with the first id 2043 has the ids up to 2048
// EXPECT no_room: cca::hardware::memory_bus: 1 ends with queues of 16 and 256 places are no bus
// EXPECT no_full_cycles: cca::hardware::link_supervisor: 0 batches in a row may meet a full queue
// EXPECT never_soft: cca::hardware::soft_stop: the joints are to get soft within 0 beats
// LINES: 15
// What the templates of buses, boards and robots on drives take, and what they say of an argument that they
// can't use.
#include <cca/cca.hpp>
#include <cca/hardware/cia402.hpp>
#include <cca/hardware/memory_bus.hpp>
#include <cca/hardware/moteus.hpp>
#include <cca/hardware/robot/robot.hpp>
#include <cca/hardware/oncilla/sensor_board.hpp>
#include <cca/hardware/safety/link_supervisor.hpp>
#include <cca/hardware/safety/stopping.hpp>

#include "../arm_on_drives.hpp"
#include "late.hpp"

struct slow_lower : cca::hardware::joint<elbow,
                                         cca::hardware::cia402<motor, 2, cca::hardware::cia402_mode::torque>,
                                         cca::hardware::mounting{.gear = 40},
                                         cca::hardware::joint_servo{.stiffness = 20},
                                         0,
                                         cca::hardware::bit_rates{500'000, 0}> {};
using both = cca::hardware::joint_list<upper, lower>;

template <class Axis, std::size_t Bus>
struct on_bus : cca::hardware::joint<Axis,
                                     cca::hardware::cia402<motor, 3, cca::hardware::cia402_mode::torque>,
                                     cca::hardware::mounting{.gear = 40},
                                     cca::hardware::joint_servo{.stiffness = 20},
                                     Bus> {};

namespace broken {

template <class Synchronizer>
auto connect_two(Synchronizer& all, bus& one) {
  return all.connect(one, one);
}

template <class Synchronizer, class Wire>
auto connect_wire(Synchronizer& all, Wire& one) {
  return all.connect(one);
}

template <class T>
using two_rates = cca::hardware::detail::bus_check<0,
                                                   cca::rate<1000>,
                                                   late<cca::hardware::no_board, T>,
                                                   cca::hardware::joint_list<upper, slow_lower>>;
template <class T>
using too_many_buses = std::is_void<decltype(connect_two(
    std::declval<
        late<cca::hardware::drive_synchronizer<bus, cca::hardware::no_board, both, cca::rate<1000>>, T>&>(),
    std::declval<bus&>()))>;
template <class T>
using other_bus = std::is_void<decltype(connect_wire(
    std::declval<
        late<cca::hardware::drive_synchronizer<bus, cca::hardware::no_board, both, cca::rate<1000>>, T>&>(),
    std::declval<cca::hardware::memory_bus<3, 16>&>()))>;
template <class T>
using unused_bus = cca::hardware::robot_buses<cca::rate<1000>,
                                              late<cca::hardware::no_board, T>,
                                              cca::hardware::joint_list<upper, on_bus<elbow, 2>>>;
template <class T>
using first_unused = cca::hardware::robot_buses<cca::rate<1000>,
                                                late<cca::hardware::no_board, T>,
                                                cca::hardware::joint_list<on_bus<shoulder, 1>>>;
template <class T>
using ids_of_board = cca::hardware::robot_board<2047, sizeof(late<char, T>), 0>;
template <class T>
using no_sensor = cca::hardware::robot_board<256, sizeof(late<char, T>) - 1, 0>;
template <class T>
using ids_of_oncilla = cca::hardware::sensor_board<2042 + sizeof(late<char, T>)>;
template <class T>
using no_room = cca::hardware::memory_bus<sizeof(late<char, T>)>;
template <class T>
using no_full_cycles = cca::hardware::link_supervisor<static_cast<int>(sizeof(late<char, T>)) - 1>;
template <class T>
using never_soft = cca::hardware::soft_stop<late<both, T>, 0>;
template <class T>
using none = late<bus, T>;

}  // namespace broken

#ifndef CCA_REJECT
constexpr auto size = sizeof(broken::none<mount>);
#else
constexpr auto size = sizeof(broken::CCA_REJECT<mount>);
#endif
