#pragma once
// The state of a world as a plain value: put it back, and a run goes on bit for bit.
//
// The engine's part is position, rotation, velocity and angular velocity of every body. The engine keeps a
// rotation both as quaternion and as matrix; both are saved, since computing one from the other would change
// bits. Forces are cleared by each step, contacts are made in each step, and joints hold no state of their
// own (measured: tests/runtime/sim/snapshot.cpp).
#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include <ode/ode.h>

#include <cca/sim/interface.hpp>
#include <cca/sim/motors.hpp>

namespace cca::sim {

inline constexpr std::size_t body_count = 1 + 4 * leg_count;  // trunk; upper, middle, lower, toe of each leg

struct body_state {
  std::array<double, 3> position;
  std::array<double, 4> quaternion;
  std::array<double, 12> rotation;  // the engine's 3 x 4 rows
  std::array<double, 3> velocity;
  std::array<double, 3> angular_velocity;
};

// The motors' memory: the last targets, the former target for the feed-forward, the cable; or the laws of
// drives with their own loops.
struct leg_motors {
  leg_command target;
  double former_hip_target = 0;
  double hip_target_speed = 0;
  cable_winch cable;
  joint_law hip_law, knee_law;
  std::int64_t by_law = 0;  // 1: the motors follow the laws, not the targets
};

// What a foot's contact has done since the start. Divide `slip` by `load` for the speed of the slip.
struct foot_account {
  double pressing = 0;       // N, the force into the ground in the last physics step
  double load = 0;           // N s, the force into the ground over time
  double slip = 0;           // N m, that force times the speed of the contact along the ground, over time
  double friction_work = 0;  // J, lost to friction
};

struct world_state {
  std::array<body_state, body_count> bodies;
  std::array<leg_motors, leg_count> motors{};
  robot_reading reading{};
  std::array<foot_account, leg_count> feet{};
  vector3 push{};               // N on the trunk, until it is set again
  double positive_work = 0;     // J, mechanical work of the motors, without braking
  double absolute_work = 0;     // J, the same, with braking counted as work
  double pantograph_error = 0;  // rad, the largest so far
  std::int64_t beats = 0;
  std::int64_t commands = 0;        // given so far
  std::int64_t trunk_contacts = 0;  // physics steps with the trunk on the ground
  std::int64_t knee_contacts = 0;   // contacts of knees and ankles
};

static_assert(std::is_trivially_copyable_v<world_state>);
static_assert(sizeof(world_state) % sizeof(double) == 0,
              "eight-byte members only: no padding, so bytes are the value");

inline bool same_bits(const world_state& a, const world_state& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

// FNV-1a over all bytes.
inline std::uint64_t hash(const world_state& s) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(&s);
  std::uint64_t h = 0xcbf29ce484222325U;
  for (std::size_t i = 0; i < sizeof s; ++i) h = (h ^ bytes[i]) * 0x100000001b3U;
  return h;
}

inline body_state save_body(dBodyID body) {
  body_state s;
  std::memcpy(s.position.data(), dBodyGetPosition(body), sizeof s.position);
  std::memcpy(s.quaternion.data(), dBodyGetQuaternion(body), sizeof s.quaternion);
  std::memcpy(s.rotation.data(), dBodyGetRotation(body), sizeof s.rotation);
  std::memcpy(s.velocity.data(), dBodyGetLinearVel(body), sizeof s.velocity);
  std::memcpy(s.angular_velocity.data(), dBodyGetAngularVel(body), sizeof s.angular_velocity);
  return s;
}

inline void restore_body(dBodyID body, const body_state& s) {
  dBodySetPosition(body, s.position[0], s.position[1],
                   s.position[2]);  // also tells the body's geometry that it moved
  // dBodySetQuaternion would normalise and change bits: write to the engine's own memory.
  std::memcpy(const_cast<dReal*>(dBodyGetQuaternion(body)), s.quaternion.data(), sizeof s.quaternion);
  std::memcpy(const_cast<dReal*>(dBodyGetRotation(body)), s.rotation.data(), sizeof s.rotation);
  dBodySetLinearVel(body, s.velocity[0], s.velocity[1], s.velocity[2]);
  dBodySetAngularVel(body, s.angular_velocity[0], s.angular_velocity[1], s.angular_velocity[2]);
  dBodySetForce(body, 0, 0, 0);
  dBodySetTorque(body, 0, 0, 0);
}

}  // namespace cca::sim
