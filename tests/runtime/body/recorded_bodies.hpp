// Bodies whose dynamics are recorded: a random tree, drawn at compile time, and a humanoid of 30 joints.
#pragma once

#include <array>
#include <cstdint>
#include <numbers>

#include <cca/mapping/serial_chain.hpp>
#include <cca/robot/body.hpp>

namespace body_test {

struct dice {
  std::uint64_t state;

  constexpr double operator()(double low, double high) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * static_cast<double>(state >> 40) / 16777216.0;
  }
  constexpr std::array<double, 3> vector(double size) {
    const double x = (*this)(-size, size), y = (*this)(-size, size), z = (*this)(-size, size);
    return {x, y, z};
  }
  constexpr std::array<double, 3> axis() {
    const double kind = (*this)(0, 8);
    const double sign = (*this)(0, 1) < 0.3 ? -1 : 1;
    if (kind < 2) return {sign, 0, 0};
    if (kind < 4) return {0, sign, 0};
    if (kind < 6) return {0, 0, sign};
    const auto v = vector(1);
    return {v[0] + 2, v[1], v[2]};
  }
  constexpr cca::placement place() {
    const auto where = vector(0.4);
    const auto about = axis();
    const double turns = (*this)(0, 3);
    return cca::at(where[0], where[1], where[2]) * cca::turned_about(about, turns < 1   ? 0
                                                                            : turns < 2 ? std::numbers::pi / 2
                                                                                        : (*this)(-3, 3));
  }
  constexpr cca::link_inertia inertia() {  // of a box, with products that keep it possible
    const double mass = (*this)(0.2, 3), x = (*this)(0.1, 0.2), y = (*this)(0.1, 0.2), z = (*this)(0.1, 0.2);
    const auto products = vector(2e-4);
    return {mass,
            vector(0.15),
            {mass * (y * y + z * z), mass * (x * x + z * z), mass * (x * x + y * y), products[0] * mass,
             products[1] * mass, products[2] * mass}};
  }
};

template <int Part>
struct random_frame {};
template <int Part, int Joint>
struct random_axis : cca::dimension<"random"> {};

// Three joints; the last one of every second part follows the first.
template <int On, int Part>
struct random_chain : cca::serial_chain<random_frame<On>,
                                        random_frame<Part>,
                                        cca::axes<random_axis<Part, 0>, random_axis<Part, 1>>> {
  static constexpr std::array joints = [] {
    dice random{static_cast<std::uint64_t>(Part + 100 + 1)};
    std::array<cca::joint, 2 + Part % 2> all;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool slides = random(0, 1) < 0.25;
      all[i] = slides ? cca::prismatic(random.axis(), random.place())
                      : cca::revolute(random.axis(), random.place());
      if (i == 2) all[i] = all[i].driven_by(0, random(0, 1) < 0.5 ? -1 : 0.5, random(-1, 1));
    }
    return all;
  }();
  static constexpr cca::placement tip = dice{static_cast<std::uint64_t>(Part + 100 + 7)}.place();
  static constexpr auto links = [] {
    dice random{static_cast<std::uint64_t>(Part + 100 + 31)};
    std::array<cca::link_inertia, joints.size()> all;
    for (auto& l : all) l = random.inertia();
    return all;
  }();
};
// Parts 0 and 2 on the base (frame -1), part 1 on part 0, part 3 beside it.
struct random_tree_body : cca::body<random_frame<-1>,
                                    cca::part<"b", random_chain<0, 1>>,
                                    cca::part<"a", random_chain<-1, 0>>,
                                    cca::part<"c", random_chain<-1, 2>>,
                                    cca::part<"d", random_chain<0, 4>>> {
  static constexpr cca::link_inertia base = dice{1}.inertia();
};

// A humanoid: legs of 6, a waist of 3, arms of 7, a head of 1.
struct pelvis : cca::frame<"pelvis"> {};
struct chest : cca::frame<"chest"> {};
struct head : cca::frame<"head"> {};
template <int Side>
struct foot {};
template <int Side>
struct hand {};
template <int Part, int Joint>
struct human_axis : cca::dimension<"human"> {};

template <int Side>
struct leg_of_human : cca::serial_chain<pelvis,
                                        foot<Side>,
                                        cca::axes<human_axis<Side, 0>,
                                                  human_axis<Side, 1>,
                                                  human_axis<Side, 2>,
                                                  human_axis<Side, 3>,
                                                  human_axis<Side, 4>,
                                                  human_axis<Side, 5>>> {
  static constexpr double left = Side == 0 ? 1 : -1;
  static constexpr std::array joints{cca::revolute(cca::along_z, cca::at(0, 0.1 * left, -0.05)),
                                     cca::revolute(cca::along_x, cca::at(0.02, 0, -0.05)),
                                     cca::revolute(cca::along_y),
                                     cca::revolute(cca::along_y, cca::at(0, 0, -0.4)),
                                     cca::revolute(cca::along_y, cca::at(0, 0, -0.4)),
                                     cca::revolute(cca::along_x)};
  static constexpr auto tip = cca::at(0.05, 0, -0.08);
  static constexpr std::array links{
      cca::link_inertia{1, {0, 0.01, 0}, {1e-3, 1e-3, 1e-3, 0, 0, 0}},
      cca::link_inertia{1.2, {0.01, 0, 0}, {1e-3, 2e-3, 1e-3, 0, 0, 1e-5}},
      cca::link_inertia{4, {0.01, 0.02 * left, -0.18}, {0.06, 0.06, 0.008, 1e-4, -1e-3, 1e-3}},
      cca::link_inertia{2.5, {0.01, 0, -0.17}, {0.04, 0.04, 0.003, 0, 1e-3, 0}},
      cca::link_inertia{0.3, {}, {1e-4, 1e-4, 1e-4, 0, 0, 0}},
      cca::link_inertia{0.8, {0.04, 0, -0.05}, {1e-3, 4e-3, 4e-3, 0, 1e-4, 0}}};
};
struct waist_of_human
    : cca::serial_chain<pelvis, chest, cca::axes<human_axis<2, 0>, human_axis<2, 1>, human_axis<2, 2>>> {
  static constexpr std::array joints{cca::revolute(cca::along_z, cca::at(0, 0, 0.1)),
                                     cca::revolute(cca::along_y, cca::at(0, 0, 0.05)),
                                     cca::revolute(cca::along_x)};
  static constexpr auto tip = cca::at(0, 0, 0.3);
  static constexpr std::array links{cca::link_inertia{0.5, {}, {1e-3, 1e-3, 1e-3, 0, 0, 0}},
                                    cca::link_inertia{0.5, {}, {1e-3, 1e-3, 1e-3, 0, 0, 0}},
                                    cca::link_inertia{14, {0.01, 0, 0.15}, {0.3, 0.25, 0.15, 0, 1e-3, 0}}};
};
template <int Side>
struct arm_of_human : cca::serial_chain<chest,
                                        hand<Side>,
                                        cca::axes<human_axis<3 + Side, 0>,
                                                  human_axis<3 + Side, 1>,
                                                  human_axis<3 + Side, 2>,
                                                  human_axis<3 + Side, 3>,
                                                  human_axis<3 + Side, 4>,
                                                  human_axis<3 + Side, 5>,
                                                  human_axis<3 + Side, 6>>> {
  static constexpr double left = Side == 0 ? 1 : -1;
  static constexpr std::array joints{
      cca::revolute(cca::along_y, cca::at(0, 0.2 * left, 0) * cca::turned_about(cca::along_x, 0.3 * left)),
      cca::revolute(cca::along_x, cca::at(0, 0.03 * left, 0)),
      cca::revolute(cca::along_z, cca::at(0, 0, -0.1)),
      cca::revolute(cca::along_y, cca::at(0.01, 0, -0.2)),
      cca::revolute(cca::along_z, cca::at(-0.01, 0, -0.1)),
      cca::revolute(cca::along_y, cca::at(0, 0, -0.12)),
      cca::revolute(cca::along_x)};
  static constexpr auto tip = cca::at(0, 0, -0.1);
  static constexpr std::array links = [] {
    dice random{7};
    std::array<cca::link_inertia, 7> all;
    for (auto& l : all) l = random.inertia();
    return all;
  }();
};
struct neck_of_human : cca::serial_chain<chest, head, cca::axes<human_axis<5, 0>>> {
  static constexpr std::array joints{cca::revolute(cca::along_z, cca::at(0, 0, 0.05))};
  static constexpr auto tip = cca::at(0, 0, 0.15);
  static constexpr std::array links{cca::link_inertia{3, {0.01, 0, 0.1}, {0.02, 0.02, 0.01, 0, 0, 0}}};
};
struct humanoid : cca::body<pelvis,
                            cca::part<"left leg", leg_of_human<0>>,
                            cca::part<"right leg", leg_of_human<1>>,
                            cca::part<"left arm", arm_of_human<0>>,
                            cca::part<"right arm", arm_of_human<1>>,
                            cca::part<"waist", waist_of_human>,
                            cca::part<"head", neck_of_human>> {
  static constexpr cca::link_inertia base{8, {0, 0, 0.02}, {0.08, 0.06, 0.07, 0, 1e-3, 0}};
};

}  // namespace body_test
