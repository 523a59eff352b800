// How many steps of 0.5 ms a second of one core makes, for robots of several sizes.
//
//   physics_rows
//
// The Oncilla and the arm on their servos; a humanoid of 30 joints in free fall; chains that swing, of 4 to
// 24 joints; a sledge that stands on 4 to 24 feet.
#define DOCTEST_CONFIG_DISABLE  // helpers of the tests are used, no test
#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <string>
#include <utility>

#include <body/bodies.hpp>
#include <body/recorded_bodies.hpp>
#include <compiled_world/robots.hpp>

#include "figures.hpp"
#include "resting.hpp"

namespace bench {

using namespace compiled_test;

// The best of five runs.
template <class World, class Laws>
void steps_a_second(const std::string& name, const World& start, const Laws& laws, int beats = 2000) {
  double most = 0;
  for (int round = 0; round < 5; ++round) {
    World w = start;
    const std::clock_t begin = std::clock();
    for (int k = 0; k < beats; ++k) w.advance(laws);
    most = std::max(most, 2.0 * beats * CLOCKS_PER_SEC / static_cast<double>(std::clock() - begin));
    if (w.trouble()) std::fprintf(stderr, "%s: %s\n", name.c_str(), w.trouble_text().c_str()), std::exit(1);
  }
  figure(name.c_str(), most);
}

struct root_frame : cca::frame<"root"> {};
struct last_frame : cca::frame<"last"> {};
template <int I>
struct hinge : cca::dimension<"hinge"> {};
template <class Numbers>
struct chain_of;
template <int... I>
struct chain_of<std::integer_sequence<int, I...>>
    : cca::serial_chain<root_frame, last_frame, cca::axes<hinge<I>...>> {
  static constexpr std::array joints{
      cca::revolute(I % 2 == 0 ? cca::along_y : cca::along_x, cca::at(0, 0, I == 0 ? 0 : -0.1))...};
  static constexpr auto tip = cca::at(0, 0, -0.1);
  static constexpr std::array links{
      (static_cast<void>(I), cca::link_inertia{0.2, {0, 0, -0.05}, {2e-4, 2e-4, 4e-5}})...};
};
template <int Joints>
struct chain_body
    : cca::body<root_frame, cca::part<"chain", chain_of<std::make_integer_sequence<int, Joints>>>> {};
template <int Joints>
void chain() {
  using R = alone<chain_body<Joints>, false>;
  sim::compiled_world<R> w;
  numbers<R> q;
  q.fill(0.1);
  w.place(q, {});
  steps_a_second("chain of " + std::to_string(Joints), w, std::span<const sim::joint_law>{});
}

template <int Feet>
struct many_feet : sledge {
  static constexpr auto shapes = [] {
    std::array<robots::shape_on, Feet> all{};
    for (int i = 0; i < Feet; ++i)
      all[static_cast<std::size_t>(i)] =
          robots::on_base(robots::sphere(radius),
                          cca::at(0.1 * (i / 2) - 0.05 * (Feet / 2 - 1), i % 2 == 0 ? -0.15 : 0.15, -0.05));
    return all;
  }();
};
template <int Feet>
void feet() {
  using R = many_feet<Feet>;
  steps_a_second("feet " + std::to_string(Feet), compiled_at<R>(cca::at(0, 0, 0.0595), level()),
                 std::span<const sim::joint_law>{});
}

}  // namespace bench

int main() {
  using namespace bench;
  steps_a_second("Oncilla", compiled_at<oncilla_description>(cca::at(0, 0, 0.18), level()),
                 holding<oncilla_description>());
  using arm = robots::arm::description;
  steps_a_second("arm", sim::compiled_world<arm>(), holding<arm>());
  steps_a_second("humanoid", sim::compiled_world<alone<body_test::humanoid, true>>(),
                 std::span<const sim::joint_law>{}, 1000);
  chain<4>(), chain<8>(), chain<12>(), chain<16>(), chain<24>();
  feet<4>(), feet<8>(), feet<16>(), feet<24>();
}
