// Spaces for the tests, one of each domain type, and their models for the laws.
#pragma once

#include "../../laws/space_laws.hpp"

namespace spaces {

struct world : cca::frame<"world"> {};
struct trunk;  // any class type is a frame

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}, cca::velocity{-6, 6}, cca::torque{-3, 3}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}};
};
using leg = cca::axes<hip, knee>;
using xyz = cca::axes<cca::x, cca::y, cca::z>;

struct leg_angles : cca::space<cca::joint_angles, leg, cca::rate<1000>> {};
struct leg_velocities : cca::space<cca::joint_velocities, leg> {};
struct leg_accelerations : cca::space<cca::joint_accelerations, leg> {};
struct leg_torques : cca::space<cca::joint_torques, leg> {};
struct leg_stiffness : cca::space<cca::joint_stiffness, leg> {};
struct leg_damping : cca::space<cca::joint_damping, leg> {};
struct foot : cca::space<cca::cartesian_position<world>, xyz> {};
struct foot_in_trunk : cca::space<cca::cartesian_position<trunk>, xyz> {};
struct attitude : cca::space<cca::orientation<world>, xyz> {};
struct attitude_in_trunk : cca::space<cca::orientation<trunk>, xyz> {};
struct foot_pose : cca::space<cca::pose<world>, xyz> {};
struct motion : cca::space<cca::twist<trunk, world>, xyz> {};
struct load : cca::space<cca::wrench<trunk, world>, xyz> {};
struct push : cca::space<cca::cartesian_force<world>, xyz> {};
struct springs : cca::space<cca::cartesian_stiffness<trunk, world>, xyz> {};
struct dampers : cca::space<cca::cartesian_damping<trunk, world>, xyz> {};
struct phases : cca::space<cca::phase, leg> {};
struct amplitudes : cca::space<cca::amplitude, leg> {};
struct frequencies : cca::space<cca::frequency, leg> {};
struct numbers : cca::space<cca::number, leg> {};
struct modes : cca::space<cca::status, leg> {};

// Independent numbers.
template <class Space, int Size = 3>
struct plain_model {
  static auto random(laws::source& random) {
    typename Space::vector_type v;
    for (int i = 0; i < Space::size; ++i) v[i] = random(-Size, Size);
    return cca::sample<Space>(v);
  }
  static bool close(const cca::sample<Space>& a, const cca::sample<Space>& b) {
    return (a.vector() - b.vector()).norm() < 1e-12;
  }
  template <class Vector>
  static auto plus(const cca::sample<Space>& a, const Vector& by) {
    return a.plus(by);
  }
};

// Joint angles; close up to whole turns.
struct angle_model : plain_model<leg_angles, 10> {
  static bool close(const cca::sample<leg_angles>& a, const cca::sample<leg_angles>& b) {
    return a.difference(b).norm() < 1e-9;
  }
};

struct phase_model : plain_model<phases, 20> {
  static bool close(const cca::sample<phases>& a, const cca::sample<phases>& b) {
    return a.difference(b).norm() < 1e-9;
  }
  static auto plus(const cca::sample<phases>& a, const Eigen::Vector2d& by) { return a.advanced(by); }
};

struct orientation_model {
  using sample = cca::sample<attitude>;
  static auto random(laws::source& random) {
    const auto q = sample::from_rotation_vector(random.vector(1.8));
    return random(0, 1) < 0.5 ? q : sample(-q.vector());  // the same rotation
  }
  static bool close(const sample& a, const sample& b) {
    return a.angle_to(b) < 1e-9 && std::abs(a.vector().norm() - 1) < 1e-12;
  }
  static auto plus(const sample& a, const Eigen::Vector3d& by) { return a.plus(by); }
  static auto point(laws::source& random) { return cca::sample<foot>(random.vector(2)); }
  static auto act(const sample& a, const cca::sample<foot>& x) { return a.rotate(x); }
};

struct pose_model {
  using sample = cca::sample<foot_pose>;
  static auto random(laws::source& random) {
    return sample::of(cca::sample<foot>(random.vector(2)), orientation_model::random(random));
  }
  static bool close(const sample& a, const sample& b) {
    return a.distance(b) < 1e-12 && a.angle_to(b) < 1e-9;
  }
  static auto point(laws::source& random) { return cca::sample<foot>(random.vector(2)); }
  static auto act(const sample& a, const cca::sample<foot>& x) { return a.transform(x); }
};

}  // namespace spaces
