// The state of a world as a plain value: put it back, and a run goes on bit for bit.
//
// Forces are cleared by each step, contacts are made in each step, and joints hold no state of their own
// (measured: tests/runtime/sim/snapshot.cpp).
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include <cca/sim/interface.hpp>
#include <cca/sim/motors.hpp>
#include <cca/sim/robot/body_state.hpp>

namespace cca::sim {

inline constexpr std::size_t body_count = 1 + 4 * leg_count;  // trunk; upper, middle, lower, toe of each leg

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

}  // namespace cca::sim
