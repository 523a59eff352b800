// Kinematics and dynamics never allocate, whatever the input.
#include <doctest/doctest.h>

#include <limits>

#include <cca/mapping/inverse_kinematics.hpp>
#include <cca/mapping/mapping_chain.hpp>
#include <cca/robot/body_components.hpp>

#include "../../laws/mapping_laws.hpp"

namespace laws {
std::size_t allocations();  // in tests/laws/allocations.cpp
}

namespace {

struct trunk : cca::frame<"trunk"> {};
struct paw : cca::frame<"paw"> {};
struct world : cca::frame<"world"> {};
struct p1 : cca::dimension<"p1"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.2, 1.2}};
};
struct p2 : cca::dimension<"p2"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.5, 0.5}};
};
struct p3 : cca::dimension<"p3"> {
  static constexpr auto limits = cca::limits{cca::angle{0.6, 2.6}};
};
using axes = cca::axes<p1, p2, p3>;
using xyz = cca::axes<cca::x, cca::y, cca::z>;

struct leg
    : cca::pantograph_leg<trunk, paw, axes, cca::pantograph{.upper = 0.08, .middle = 0.1, .lower = 0.06}> {
  static constexpr std::array<cca::link_inertia, 4> links{cca::link_inertia{},
                                                          {0.2, {0, 0, -0.04}, {1e-3, 1e-3, 1e-4, 0, 0, 0}},
                                                          {0.1, {0, 0, -0.05}, {1e-3, 1e-3, 1e-4, 0, 0, 0}},
                                                          {0.05, {0, 0, -0.03}, {}}};
};
struct plain_leg : cca::serial_chain<trunk, paw, axes> {
  static constexpr auto joints = leg::joints;
  static constexpr auto tip = leg::tip;
};
struct dog : cca::body<trunk, cca::part<"leg", leg>> {};
struct angles : cca::space<cca::joint_angles, axes> {};
struct velocities : cca::space<cca::joint_velocities, axes> {};
struct accelerations : cca::space<cca::joint_accelerations, axes> {};
struct torques : cca::space<cca::joint_torques, axes> {};
struct place : cca::space<cca::cartesian_position<trunk>, xyz> {};
struct place_in_world : cca::space<cca::cartesian_position<world>, xyz> {};
struct trunk_in_world : cca::placed<trunk, world> {
  static constexpr auto where = cca::at(1, 0, 0.2) * cca::turned_about(cca::along_z, 1);
};

}  // namespace

TEST_SUITE("body") {
  TEST_CASE("kinematics and dynamics do not allocate") {
    cca::inverse_kinematics<leg, angles, place> closed;
    cca::inverse_kinematics<plain_leg, angles, place> general;
    cca::mapping_chain<cca::forward_kinematics<leg, angles, place>,
                       cca::frame_change<trunk_in_world, place, place_in_world>>
        in_world;
    cca::gravity_compensation<dog, angles, torques> gravity;
    cca::inverse_dynamics_of<dog, angles, velocities, accelerations, torques> dynamics;
    laws::source random{std::mt19937_64{51}};
    double sum = 0;
    const std::size_t before = laws::allocations();
    for (int i = 0; i < 100; ++i) {
      Eigen::Vector3d target = random.vector(0.3);
      if (i % 10 == 0) target[1] = std::numeric_limits<double>::quiet_NaN();
      const Eigen::Vector3d q = std::get<0>(laws::map_all(closed, target)).vector();
      sum += std::get<0>(laws::map_all(general, target)).vector().sum() + laws::map(in_world, q).sum() +
             laws::map(gravity, q).sum();
      sum +=
          dynamics
              .process(cca::in<"angles", angles>(q, 0, true), cca::in<"velocities", velocities>(q, 0, true),
                       cca::in<"accelerations", accelerations>(q, 0, true), {})
              .vector()
              .sum();
    }
    const std::size_t after = laws::allocations();
    CHECK(after == before);
    CHECK(std::isfinite(sum));
  }
}
