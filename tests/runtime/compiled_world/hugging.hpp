#pragma once
// A robot that touches itself, and it in lanes beside worlds alone.
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include <cca/robots/description.hpp>
#include <cca/sim/compiled/compiled_world.hpp>
#include <cca/sim/compiled/lanes/lanes.hpp>

namespace compiled_test {

namespace robots = cca::robots;
namespace sim = cca::sim;

// A trunk with two arms of three joints: upper arm, a link without a shape, forearm with a hand.
struct trunk_frame : cca::frame<"trunk"> {};
struct left_hand : cca::frame<"left_hand"> {};
struct right_hand : cca::frame<"right_hand"> {};
template <cca::fixed_string Name>
struct turning : cca::dimension<Name> {
  static constexpr auto limits = cca::limits{cca::angle{-3, 3}};
};
struct left_shoulder : turning<"left_shoulder"> {};
struct left_twist : turning<"left_twist"> {};
struct left_elbow : turning<"left_elbow"> {};
struct right_shoulder : turning<"right_shoulder"> {};
struct right_twist : turning<"right_twist"> {};
struct right_elbow : turning<"right_elbow"> {};
template <int Side, class Hand, class Axes>
struct arm_chain : cca::serial_chain<trunk_frame, Hand, Axes> {
  static constexpr std::array joints{
      cca::revolute(cca::along_y, cca::at(0.1 - 0.2 * Side, 0.02, 0.15)),
      cca::revolute(cca::along_z, cca::at(0, 0, -0.1)),
      cca::revolute(cca::along_y, cca::at(0, 0, -0.1)),
  };
  static constexpr auto tip = cca::at(0, 0, -0.2);
  static constexpr std::array links{
      cca::link_inertia{0.5, {0, 0, -0.1}, {2e-3, 2e-3, 5e-4, 0, 0, 0}},
      cca::link_inertia{0.1, {0, 0, -0.05}, {2e-4, 2e-4, 2e-4, 0, 0, 0}},
      cca::link_inertia{0.4, {0, 0, -0.1}, {2e-3, 2e-3, 5e-4, 0, 0, 0}},
  };
};
struct hugging {
  using left = arm_chain<0, left_hand, cca::axes<left_shoulder, left_twist, left_elbow>>;
  using right = arm_chain<1, right_hand, cca::axes<right_shoulder, right_twist, right_elbow>>;
  struct body : cca::body<trunk_frame, cca::part<"left", left>, cca::part<"right", right>> {
    static constexpr cca::link_inertia base{3, {0, 0, 0}, {0.05, 0.04, 0.03, 0, 0, 0}};
  };
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  using sensors = robots::sensors<robots::force_sensor<"hand_load", "left">>;
  static constexpr bool floats = true, touches_itself = true;
  static constexpr auto drives = [] {
    std::array<robots::joint_drive, 6> all{};
    for (auto& d : all) d.motor = {5, 50}, d.stops = false;
    return all;
  }();
  static constexpr std::array shapes{
      robots::on_base(robots::box(0.16, 0.2, 0.4)),
      robots::on_link("left", 0, robots::capsule(0.03, 0.14), cca::at(0, 0, -0.1)),
      robots::on_link("left", 2, robots::capsule(0.03, 0.14), cca::at(0, 0, -0.1)),
      robots::at_tip("left", robots::sphere(0.04)),
      robots::on_link("right", 0, robots::capsule(0.03, 0.14), cca::at(0, 0, -0.1)),
      robots::on_link("right", 2, robots::box(0.05, 0.05, 0.2), cca::at(0, 0, -0.1)),
      robots::at_tip("right", robots::sphere(0.04)),
  };
};

struct hugs_in_lanes {
  int differ = 0;             // numbers of lanes that are not those of a world alone
  int touches = 0;            // beats of a lane in which its hands press or are pressed
  int apart = 0;              // those in which another lane's do not
  int on_boxes = 0;           // beats of a lane in which trunk and forearm press, boxes
  bool stands_still = false;  // a world has trouble
};
// Each lane swings its arms in its own way, from its own posture.
template <int Width>
hugs_in_lanes hugs_beside_alone(const sim::scene& around, double gravity, int beats) {
  using several = sim::lanes<Width>;
  sim::robot_world_settings settings;
  settings.engine.gravity = gravity, settings.steps_per_beat = 2;
  const auto begins = [](int l, std::size_t c) {
    constexpr std::array<double, 6> q{-0.7, 0.1, 0.2, 0.7, 0, -0.3};
    return q[c] + 0.03 * l * (c % 2 == 0 ? 1 : -1);
  };
  const auto swings = [](int l, int beat) {
    const double in = std::sin(0.02 * beat + 0.9 * l), out = std::sin(0.013 * beat + 0.4 * l);
    const std::array<double, 6> to{-0.4 + 0.6 * in, 0.1 * out, 0.6 + 0.6 * out,
                                   0.1 + 0.4 * in,  0.1 * in,  -0.3 - 0.6 * out};
    std::array<sim::joint_law, 6> laws;
    for (std::size_t c = 0; c < 6; ++c) laws[c] = {.position = to[c], .stiffness = 8, .damping = 0.4};
    return laws;
  };
  const cca::placement base = cca::at(0, 0, 0.21);
  const auto all = std::make_unique<sim::compiled_world<hugging, several>>(around, settings);
  std::array<several, 6> q;
  for (std::size_t c = 0; c < 6; ++c)
    for (int l = 0; l < Width; ++l) q[c].set(l, begins(l, c));
  all->place(q, {}, base, {}, {});
  std::vector<sim::compiled_world<hugging>> alone(Width, sim::compiled_world<hugging>(around, settings));
  for (int l = 0; l < Width; ++l) {
    std::array<double, 6> own{};
    for (std::size_t c = 0; c < 6; ++c) own[c] = begins(l, c);
    alone[static_cast<std::size_t>(l)].place(own, {}, base, {}, {});
  }
  hugs_in_lanes found;
  for (int beat = 0; beat < beats; ++beat) {
    std::vector<sim::joint_law> laws;
    int touching = 0;
    for (int l = 0; l < Width; ++l) {
      auto& w = alone[static_cast<std::size_t>(l)];
      const auto own = swings(l, beat);
      laws.insert(laws.end(), own.begin(), own.end());
      w.advance(own);
      touching += w.contact(3).pressing > 0 || w.contact(6).pressing > 0;
      found.on_boxes += w.contact(0).pressing > 0 && w.contact(5).pressing > 0;
    }
    all->advance(laws);
    found.touches += touching;
    if (touching < Width) found.apart += touching;
    const auto& of = all->save();
    for (int l = 0; l < Width; ++l) {
      const auto& one = alone[static_cast<std::size_t>(l)].save();
      const auto compare = [&](double x, const several& y) { found.differ += !(x == y[l]); };
      for (std::size_t c = 0; c < 6; ++c)
        compare(one.motion.q[c], of.motion.q[c]), compare(one.motion.dq[c], of.motion.dq[c]);
      for (std::size_t k = 0; k < 3; ++k) {
        compare(one.motion.at[k], of.motion.at[k]), compare(one.end_forces[0][k], of.end_forces[0][k]);
        compare(one.loads[0][k], of.loads[0][k]);
      }
      found.stands_still = found.stands_still || one.trouble || of.trouble;
    }
  }
  return found;
}

}  // namespace compiled_test
