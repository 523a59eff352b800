#pragma once
// A leg that swings, and a guard that stops it when its hip moves too fast. docs/recordings.md
#include <cmath>
#include <cstdint>

#include <cca/cca.hpp>

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}, cca::velocity{-4.0, 4.0}};
};
struct hip_angle : cca::space<cca::joint_angles, cca::axes<hip>, cca::rate<1000>> {};
struct hip_velocity : cca::space<cca::joint_velocities, cca::axes<hip>, cca::rate<1000>> {};

// The robot of the field: its encoder is noisy, and in beat 1234 a frame has a wrong bit.
struct leg {
  auto sense() -> cca::out<"angle", hip_angle> {
    noise = noise * 6364136223846793005u + 1442695040888963407u;
    const double measured = at + 1e-4 * static_cast<double>(noise >> 40) / (1 << 24);
    return beat++ == 1234 ? measured + 0.5 : measured;
  }
  void act(cca::in<"command", hip_angle> to) { at = to[hip{}]; }
  std::uint64_t noise = 17;
  std::int64_t beat = 0;
  double at = 0;
};

struct swing {
  auto process(cca::beat now) -> cca::out<"angle", hip_angle> {
    return 0.3 * cca::math::sin(3e-9 * static_cast<double>(now.time()));
  }
};

// As it was in the field: the difference of two angles.
struct difference {
  auto process(cca::in<"angle", hip_angle> angle, cca::beat now) -> cca::out<"velocity", hip_velocity> {
    const double velocity = (angle[hip{}] - last) / now.dt();
    last = angle[hip{}];
    return velocity;
  }
  double last = 0;
};

// Repaired: a step that no leg can make is left out, but not many in a row.
// [repaired]
struct checked_difference {
  auto process(cca::in<"angle", hip_angle> angle, cca::beat now) -> cca::out<"velocity", hip_velocity> {
    time += now.dt();
    const double step = angle[hip{}] - last;
    if (!(std::abs(step) < 0.02) && ++left_out < 3) return velocity;
    velocity = step / time;
    last = angle[hip{}];
    time = 0;
    left_out = 0;
    return velocity;
  }
  double last = 0, time = 0, velocity = 0;
  int left_out = 0;
};
// [repaired end]

struct guard {
  auto process(cca::in<"velocity", hip_velocity> measured) -> cca::fault {
    return std::abs(measured[hip{}]) < 10 ? cca::fault() : cca::fault("the hip is faster than 10 rad/s");
  }
};

// [graph]
template <class Velocity>
struct leg_loop : cca::graph<cca::node<"leg", leg>,
                             cca::node<"swing", swing, cca::timed<1>>,
                             cca::node<"velocity", Velocity>,
                             cca::node<"guard", guard>,
                             cca::node<"limits", cca::limiter<hip_angle>>,
                             cca::wire<"leg.angle", "velocity.angle">,
                             cca::wire<"velocity.velocity", "guard.velocity">,
                             cca::wire<"swing.angle", "limits.command">,
                             cca::wire<"limits.safe", "leg.command">>,
                  cca::recordable,
                  cca::traceable {};
// [graph end]
