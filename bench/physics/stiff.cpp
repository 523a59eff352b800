// Strong gains and uneven masses in both engines: whether they stay in hand, and come to rest as the robot
// does by itself.
//
//   physics_stiff
#include <random>

#include "resting.hpp"

namespace bench {

// Gains of servos and cables, and what their motors can give.
template <int Gain, int Torque>
struct stiff : oncilla_description {
  static constexpr auto drives = [] {
    auto all = oncilla_description::drives;
    for (auto& d : all) {
      d.motor.torque *= Torque, d.stiffness *= Gain, d.damping *= Gain;
      d.cable.stiffness *= Gain, d.cable.damping *= Gain;
    }
    return all;
  }();
};

// The largest speed of a joint in the last of 30 s, rad/s; infinite if the world stands still before.
template <class R, class World>
double restless(World w) {
  const auto laws = holding<R>();
  double most = 0;
  for (int k = 0; k < 30000; ++k) {
    w.advance(laws);
    if (w.trouble()) return std::numeric_limits<double>::infinity();
    if (k >= 29000)
      for (const auto& j : w.joints()) most = std::max(most, std::abs(j.velocity));
  }
  return most;
}
template <class R>
void stands(const std::string& name) {
  const cca::placement above = cca::at(0, 0, 0.18);
  figure(("compiled " + name).c_str(), restless<R>(compiled_at<R>(above, level())));
  figure(("ode " + name).c_str(), restless<R>(engine_at<R>(above, level())));
}

// A trunk 10,000 times as heavy as a toe; springs, gains and ground carry it as they carry the robot.
constexpr double heavier = 10000 * robots::oncilla::body.toe_mass / robots::oncilla::body.trunk_mass;
struct heavy_body : robots::oncilla::walking_body {
  static constexpr cca::link_inertia base = [] {
    auto b = robots::oncilla::walking_body::base;
    b.mass *= heavier;
    for (double& x : b.about_centre) x *= heavier;
    return b;
  }();
};
struct heavy : oncilla_description {
  using body = heavy_body;
  static constexpr auto drives = [] {
    auto all = oncilla_description::drives;
    for (auto& d : all) {
      d.motor.torque *= heavier, d.stiffness *= heavier, d.damping *= heavier, d.spring *= heavier,
          d.friction *= heavier;
      d.cable.stiffness *= heavier, d.cable.damping *= heavier;
    }
    return all;
  }();
  static constexpr auto line_springs = [] {
    auto all = oncilla_description::line_springs;
    for (auto& l : all) l.stiffness *= heavier;
    return all;
  }();
};
void heavy_on_light() {
  const cca::placement above = cca::at(0, 0, 0.18);
  sim::scene hard = level();
  hard.contact.stiffness *= heavier, hard.contact.damping *= heavier;
  figure("compiled heavy trunk", restless<heavy>(compiled_at<heavy>(above, hard)));
  figure("ode heavy trunk", restless<heavy>(engine_at<heavy>(above, hard)));
}

// Links that move freely, and carry `Ratio` times their mass.
struct hook_frame : cca::frame<"hook"> {};
struct weight_frame : cca::frame<"weight"> {};
template <int I>
struct swing : cca::dimension<"swing"> {};
template <int Ratio>
struct light_chain
    : cca::serial_chain<hook_frame,
                        weight_frame,
                        cca::axes<swing<0>, swing<1>, swing<2>, swing<3>, swing<4>, swing<5>>> {
  static constexpr auto below = cca::at(0, 0, -0.1);
  static constexpr std::array joints{cca::revolute(cca::along_y),        cca::revolute(cca::along_x, below),
                                     cca::revolute(cca::along_y, below), cca::revolute(cca::along_x, below),
                                     cca::revolute(cca::along_y, below), cca::revolute(cca::along_x, below)};
  static constexpr auto tip = cca::at(0, 0, -0.1);
  static constexpr double m = 1.0 / Ratio;
  static constexpr cca::link_inertia light{m, {0, 0, -0.05}, {m * 0.001, m * 0.001, m * 0.0002}},
      weight{1, {0, 0, -0.05}, {0.002, 0.002, 0.002}};
  static constexpr std::array links{light, light, light, light, light, weight};
};
template <int Ratio>
struct light_body : cca::body<hook_frame, cca::part<"chain", light_chain<Ratio>>> {};
template <int Ratio>
struct light {
  using body = light_body<Ratio>;
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  static constexpr std::array<robots::joint_drive, 6> drives{};
};
// J, at most, that it gains in 10 s, of 10 starts; infinite if a world stands still.
template <class Make>
double gained(Make make) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  double most = 0;
  for (int start = 0; start < 10; ++start) {
    auto w = make();
    std::array<double, 6> q, dq;
    for (std::size_t c = 0; c < 6; ++c) q[c] = any(random), dq[c] = any(random);
    w.place(q, dq);
    const double before = w.energy();
    for (int k = 0; k < 10000; ++k) {
      w.advance(std::span<const sim::joint_law>{});
      if (w.trouble()) {
        std::fprintf(stderr, "start %d after %d beats, %g J: %s\n", start, k, most, w.trouble_text().c_str());
        return std::numeric_limits<double>::infinity();
      }
      most = std::max(most, w.energy() - before);
    }
  }
  return most;
}
template <int Ratio>
void swings() {
  const std::string name = "chain of 1 to " + std::to_string(Ratio);
  figure(("compiled " + name).c_str(), gained([] { return sim::compiled_world<light<Ratio>>(); }));
  figure(("ode " + name).c_str(), gained([] { return sim::robot_world(sim::model_of<light<Ratio>>()); }));
}

}  // namespace bench

int main() {
  using namespace bench;
  stands<oncilla_description>("gains x1");
  stands<stiff<100, 1>>("gains x100");
  stands<stiff<1000, 1>>("gains x1000");
  stands<stiff<1000, 1000>>("gains and torques x1000");
  heavy_on_light();
  swings<100>();
  swings<1000>();
  swings<10000>();
}
