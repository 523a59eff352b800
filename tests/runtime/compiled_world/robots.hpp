#pragma once
// Robots for the tests of compiled worlds: bodies without drives, and states of them.
#include <array>
#include <cstddef>
#include <string_view>

#include <cca/robot/dynamics/momentum.hpp>
#include <cca/robots/arm/description.hpp>
#include <cca/robots/oncilla/description.hpp>
#include <cca/sim/compiled/compiled_world.hpp>

#include "../../laws/space_laws.hpp"

namespace compiled_test {

namespace robots = cca::robots;
namespace sim = cca::sim;

// A body, and nothing that acts on its joints.
template <class Body, bool Floats>
struct alone {
  using body = Body;
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  static constexpr bool floats = Floats;
  static constexpr auto drives = [] {
    std::array<robots::joint_drive, static_cast<std::size_t>(cca::axes_of<Body>::count)> all{};
    for (auto& d : all) d.stops = false;
    return all;
  }();
};
using flying_oncilla = alone<robots::oncilla::walking_body, true>;
using limp_arm = alone<robots::arm::body, false>;

template <class R>
constexpr std::size_t coordinates = static_cast<std::size_t>(cca::axes_of<typename R::body>::count);
template <class R>
using numbers = std::array<double, coordinates<R>>;

template <class R>
numbers<R> random_numbers(laws::source& random, double size) {
  numbers<R> all;
  for (double& x : all) x = random(-size, size);
  return all;
}
inline cca::placement random_place(laws::source& random) {
  cca::placement p = cca::at(random(-1, 1), random(-1, 1), random(-1, 1));
  const Eigen::Vector4d q =
      Eigen::Vector4d(random(-1, 1), random(-1, 1), random(-1, 1), random(-1, 1)).normalized();
  p.rotation = {q[0], q[1], q[2], q[3]};
  return p;
}

template <class R>
auto pose_of(const sim::compiled_world<R>& w) {
  using pose = cca::body_pose<typename R::body>;
  return pose(pose::vector_type::Map(w.save().motion.q.data()));
}
template <class R>
auto speeds_of(const sim::compiled_world<R>& w) {
  return Eigen::Matrix<double, static_cast<int>(coordinates<R>), 1>(
      Eigen::Matrix<double, static_cast<int>(coordinates<R>), 1>::Map(w.save().motion.dq.data()));
}

}  // namespace compiled_test
