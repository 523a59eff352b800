// EXPECT plus_three: space\.wrong_length: `plus` of leg_angles \(joint_angles over hip, knee\) takes a vector of 2 numbers, and this one has 3: give one of 2
// EXPECT plus_row: space\.wrong_length: `plus` of leg_angles \(joint_angles over hip, knee\) takes a vector of 2 numbers, and this one is a row: write `\.transpose\(\)` behind it
// EXPECT springs: space\.wrong_length: `torque` of leg_stiffness \(joint_stiffness over hip, knee\) takes a vector of 2 numbers, and this one has 3
// EXPECT advanced: space\.wrong_length: `advanced` of leg_phases \(phase over hip, knee\) takes a vector of 2 numbers, and this one has 3
// EXPECT point: space\.wrong_length: `plus` of place \(cartesian_position<world> over x, y, z\) takes a vector of 3 numbers, and this one has 2
// EXPECT six_springs: space\.wrong_length: `wrench` of springs_at_foot \(cartesian_stiffness<foot, world> over x, y, z\) takes a vector of 6 numbers, and this one has 3
// EXPECT lever: space\.wrong_length: `moved_to` of load_at_foot \(wrench<foot, trunk> over x, y, z\) takes a vector of 3 numbers, and this one has 2
// EXPECT axis: space\.wrong_length: `about` of attitude \(orientation<world> over x, y, z\) takes a vector of 3 numbers, and this one has 2
// EXPECT turn: space\.wrong_length: `from_rotation_vector` of attitude \(orientation<world> over x, y, z\) takes a vector of 3 numbers, and this one has 4
// EXPECT turned_further: space\.wrong_length: `plus` of attitude \(orientation<world> over x, y, z\) takes a vector of 3 numbers, and this one has 4
// EXPECT rotated: space\.wrong_length: `rotate` of attitude \(orientation<world> over x, y, z\) takes a vector of 3 numbers, and this one has 2
// EXPECT moved: space\.wrong_length: `transform` of foot_pose \(pose<world> over x, y, z\) takes a vector of 3 numbers, and this one has 2
// EXPECT part_of_whole: space\.unknown_axis: foot_pose \(pose<world> over x, y, z\) has 7 numbers over 3 axes, so none of them is that of an axis
// EXPECT not_expressed: space\.mismatch: a rotation moves samples over three axes, axes<x, y, z>, that are positions, forces, twists or wrenches, and this one is of leg_angles
// EXPECT one_number: component\.bad_result: the output `y` is made from 1 number, and a sample of leg_angles \(joint_angles over hip, knee\) from a vector: write `Eigen::Vector<double, 2>\{\.\.\.\}`
// EXPECT two_numbers: component\.bad_result: the output `y` is made from 2 numbers, and a sample of leg_angles \(joint_angles over hip, knee\) from a vector
// EXPECT maybe_one_number: component\.bad_result: the output `y` is made from 1 number, and a sample of leg_angles
// LINES: 21
// What the functions of samples and the outputs of components say of vectors and numbers that they can't use,
// where a whole graph has such a component. Up to six of the lines are of this file.
#include <cca/cca.hpp>

#include "../parts.hpp"
#include "late.hpp"

struct leg_stiffness : cca::space<cca::joint_stiffness, cca::axes<hip, knee>> {};
struct leg_phases : cca::space<cca::phase, cca::axes<hip, knee>> {};
struct foot : cca::frame<"foot"> {};
struct load_at_foot : cca::space<cca::wrench<foot, trunk>, xyz> {};
struct foot_pose : cca::space<cca::pose<world>, xyz> {};
struct springs_at_foot : cca::space<cca::cartesian_stiffness<foot, world>, xyz> {};

struct sink {
  void process(cca::in<"x", leg_angles>) {}
};
template <class Component>
using publishing = cca::
    graph<cca::rate<1000>, cca::node<"from", Component>, cca::node<"to", sink>, cca::wire<"from.y", "to.x">>;

namespace broken {

// A component that calls a function of a sample.
template <class Mistake>
struct doing {
  auto process(cca::beat) -> cca::out<"y", leg_angles> {
    Mistake::done();
    return {};
  }
};
template <class Mistake>
using calling = publishing<doing<Mistake>>;
template <class Space, class T>
cca::sample<late<Space, T>> a;
template <int Rows, int Columns = 1>
const Eigen::Matrix<double, Rows, Columns> given = Eigen::Matrix<double, Rows, Columns>::Zero();

// clang-format off
template <class T> struct adds_three { static auto done() { return a<leg_angles, T>.plus(given<3>); } };
template <class T> struct adds_row { static auto done() { return a<leg_angles, T>.plus(given<1, 2>); } };
template <class T> struct turns_springs { static auto done() { return a<leg_stiffness, T>.torque(given<3>); } };
template <class T> struct advances { static auto done() { return a<leg_phases, T>.advanced(given<3>); } };
template <class T> struct adds_to_point { static auto done() { return a<place, T>.plus(given<2>); } };
template <class T> struct displaces { static auto done() { return a<springs_at_foot, T>.wrench(given<3>); } };
template <class T> struct moves_load { static auto done() { return a<load_at_foot, T>.template moved_to<trunk>(given<2>); } };
template <class T> struct turns_about { static auto done() { return a<attitude, T>.about(given<2>, 1); } };
template <class T> struct turns { static auto done() { return a<attitude, T>.from_rotation_vector(given<4>); } };
template <class T> struct turns_further { static auto done() { return a<attitude, T>.plus(given<4>); } };
template <class T> struct rotates { static auto done() { return a<attitude, T>.rotate(given<2>); } };
template <class T> struct transforms { static auto done() { return a<foot_pose, T>.transform(given<2>); } };
template <class T> struct takes_part { static auto done() { return a<foot_pose, T>.template on<cca::x>(); } };
template <class T> struct expresses { static auto done() { return a<attitude, T>.express(a<leg_angles, T>); } };
// clang-format on
template <class T>
using plus_three = calling<adds_three<T>>;
template <class T>
using plus_row = calling<adds_row<T>>;
template <class T>
using springs = calling<turns_springs<T>>;
template <class T>
using advanced = calling<advances<T>>;
template <class T>
using point = calling<adds_to_point<T>>;
template <class T>
using six_springs = calling<displaces<T>>;
template <class T>
using lever = calling<moves_load<T>>;
template <class T>
using axis = calling<turns_about<T>>;
template <class T>
using turn = calling<turns<T>>;
template <class T>
using turned_further = calling<turns_further<T>>;
template <class T>
using rotated = calling<rotates<T>>;
template <class T>
using moved = calling<transforms<T>>;
template <class T>
using part_of_whole = calling<takes_part<T>>;
template <class T>
using not_expressed = calling<expresses<T>>;

template <class T>
struct publishes_one {
  auto process(cca::beat) -> cca::out<"y", late<leg_angles, T>> { return 1.0; }
};
template <class T>
using one_number = publishing<publishes_one<T>>;
template <class T>
struct publishes_two {
  auto process(cca::beat) -> cca::out<"y", late<leg_angles, T>> { return {1.0, 2.0}; }
};
template <class T>
using two_numbers = publishing<publishes_two<T>>;
template <class T>
struct may_publish_one {
  auto process(cca::beat) -> cca::maybe<"y", late<leg_angles, T>> { return 1; }
};
template <class T>
using maybe_one_number = publishing<may_publish_one<T>>;
template <class T>
struct stands {
  auto process(cca::beat) -> cca::out<"y", late<leg_angles, T>> { return {}; }
};
template <class T>
using none = publishing<stands<T>>;

}  // namespace broken

#ifndef CCA_REJECT
cca::controller<broken::none<trunk>> walk;
#else
cca::controller<broken::CCA_REJECT<trunk>> walk;
#endif
