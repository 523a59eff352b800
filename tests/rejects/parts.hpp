// The parts of the architectures in this folder: a leg, what moves it, and places and attitudes in the world.
#pragma once

#include <cca/cca.hpp>

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}, cca::torque{-3.0, 3.0}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}, cca::torque{-3.0, 3.0}};
};

struct gait_phase : cca::space<cca::phase, cca::axes<cca::x>> {};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
struct leg_torques : cca::space<cca::joint_torques, cca::axes<hip, knee>> {};

struct world : cca::frame<"world"> {};
struct trunk : cca::frame<"trunk"> {};
using xyz = cca::axes<cca::x, cca::y, cca::z>;
struct attitude : cca::space<cca::orientation<world>, xyz> {};
struct place : cca::space<cca::cartesian_position<world>, xyz> {};

struct oscillator {
  auto process(cca::beat now) -> cca::out<"phase", gait_phase> {
    return 1e-9 * static_cast<double>(now.time());
  }
};

struct gait {
  auto process(cca::in<"phase", gait_phase> phase) -> cca::out<"angles", leg_angles> {
    return 0.2 * phase.vector().replicate<2, 1>();
  }
};

struct stance {
  auto process(cca::beat) -> cca::out<"angles", leg_angles> { return {}; }
};

struct posture {
  auto process(cca::in<"angles", leg_angles> angles) -> cca::out<"angles", leg_angles> { return angles; }
};

struct recorder {
  void process(cca::in<"angles", leg_angles>) {}
};

struct comparison {
  void process(cca::in<"wanted", leg_angles>, cca::in<"actual", leg_angles>) {}
};

struct leg {
  auto sense() -> cca::out<"angles", leg_angles> { return {}; }
  void act(cca::in<"command", leg_angles>) {}
};

// Reads every output that no wire leads from: each architecture here is complete but for its one mistake, so
// a new rule does not break the others' files.
struct logbook {
  void process(cca::observe<"**">) {}
};
