#pragma once
// A recorded run, beat by beat: the data of the table, the CSV file and the picture.
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include <cca/sim/oncilla/asked_by_leg.hpp>
#include <cca/sim/oncilla/attitude.hpp>

namespace trot {

inline constexpr std::array<std::string_view, 4> leg_names{"left front", "right front", "left hind",
                                                           "right hind"};
inline constexpr std::array<std::string_view, 4> leg_keys{"lf", "rf", "lh", "rh"};

struct moment {
  double time;  // s
  cca::sim::vector3 position;
  cca::sim::roll_pitch_yaw attitude;
  std::array<double, 4> hip, knee, hip_command, knee_command;  // rad
  std::array<double, 4> foot_force;                            // N, upwards
  std::array<bool, 4> contact;
};

// From then on a trot is steady, s.
inline constexpr double settled = 2.0;

struct recording {
  std::vector<moment> moments;
  cca::sim::vector3 start{};
  double beat = 0.001;
  double mass = 0, gravity = 9.81;
  double work = 0;  // J, positive mechanical work of all motors over the run
  std::array<cca::sim::foot_account, 4> feet{}, feet_when_settled{};  // what each foot has done so far
  bool fell = false;

  template <class World>  // asked by leg, whatever engine it has
  void begin(const World& w, std::size_t beats) {
    moments.reserve(beats);
    start = w.trunk_position();
    beat = w.model().beat;
    mass = w.mass();
    gravity = w.settings().engine.gravity;
  }

  template <class World>
  void note(const World& w) {
    const cca::sim::robot_reading r = w.reading();
    const cca::sim::robot_command taken = w.targets();
    moment m;
    m.time = w.time();
    m.position = w.trunk_position();
    m.attitude = cca::sim::attitude(r.trunk.orientation);
    for (std::size_t i = 0; i < 4; ++i) {
      m.hip[i] = r.legs[i].hip.angle;
      m.knee[i] = r.legs[i].knee.angle;
      m.hip_command[i] = taken[i].hip;
      m.knee_command[i] = taken[i].knee;
      m.foot_force[i] = r.legs[i].foot_force[2];
      m.contact[i] = r.legs[i].contact();
    }
    moments.push_back(m);
    work = w.positive_work();
    for (std::size_t i = 0; i < 4; ++i) feet[i] = w.foot(i);
    if (m.time <= settled) feet_when_settled = feet;
    fell = fell || w.fallen();
  }
};

}  // namespace trot
