// Twelve random bodies in one file: what is recorded of each, against the loops. A compiler that evaluates
// constants remembers results from one body to the next.
#include <doctest/doctest.h>

#include <utility>

#include <cca/robot/dynamics/derivatives.hpp>

#include "../../laws/space_laws.hpp"
#include "recorded_bodies.hpp"

namespace random_bodies_test {

using body_test::dice;
namespace cd = cca::detail;

template <int Seed, int Part>
constexpr dice dice_of(int use) {
  return {static_cast<std::uint64_t>(Seed * 977 + Part * 59 + use)};
}
template <int Seed, int Part>
struct frame {};
template <int Seed, int Part, int Joint>
struct axis : cca::dimension<"random"> {};

// One to three joints, of any kind.
template <int Seed, int Part>
inline constexpr int joint_count = 1 + static_cast<int>(dice_of<Seed, Part>(1)(0, 3));
template <int Seed, int Part, class Joints = std::make_integer_sequence<int, joint_count<Seed, Part>>>
struct axes_of_chain;
template <int Seed, int Part, int... Joint>
struct axes_of_chain<Seed, Part, std::integer_sequence<int, Joint...>> {
  using type = cca::axes<axis<Seed, Part, Joint>...>;
};
// On the base (-1), or on a part before.
template <int Seed, int Part>
inline constexpr int parent = static_cast<int>(dice_of<Seed, Part>(3)(0, Part + 1)) - 1;

template <int Seed, int Part>
struct chain : cca::serial_chain<frame<Seed, parent<Seed, Part>>,
                                 frame<Seed, Part>,
                                 typename axes_of_chain<Seed, Part>::type> {
  static constexpr auto joints = [] {
    dice random = dice_of<Seed, Part>(5);
    std::array<cca::joint, static_cast<std::size_t>(joint_count<Seed, Part>)> all;
    for (auto& j : all)
      j = random(0, 1) < 0.3 ? cca::prismatic(random.axis(), random.place())
                             : cca::revolute(random.axis(), random.place());
    return all;
  }();
  static constexpr cca::placement tip = dice_of<Seed, Part>(7).place();
  static constexpr auto links = [] {
    dice random = dice_of<Seed, Part>(9);
    std::array<cca::link_inertia, joints.size()> all;
    for (auto& l : all) l = random.inertia();
    return all;
  }();
};
template <int Seed>
struct body : cca::body<frame<Seed, -1>,
                        cca::part<"a", chain<Seed, 0>>,
                        cca::part<"b", chain<Seed, 1>>,
                        cca::part<"c", chain<Seed, 2>>> {};

template <class Matrix>
void check(const char* what, const Matrix& found, const Matrix& wanted) {
  INFO(what);
  CHECK((found - wanted).cwiseAbs().maxCoeff() < 1e-12 * (1 + wanted.cwiseAbs().maxCoeff()));
  CHECK(wanted.cwiseAbs().maxCoeff() > 1e-3);
}

template <int Seed>
inline constexpr bool is_recorded = cd::is_recorded<cd::recorded_coriolis_matrix<body<Seed>>>();

template <int Seed>
void check_body() {
  INFO("seed ", Seed);
  using pose = cca::body_pose<body<Seed>>;
  constexpr const auto& links = cd::weighed_links_of<body<Seed>>;
  laws::source random{std::mt19937_64{Seed + 1}};
  for (int round = 0; round < 5; ++round) {
    typename pose::vector_type q, dq, ddq;
    for (auto& x : q) x = random(-3, 3);
    for (auto& x : dq) x = random(-2, 2);
    for (auto& x : ddq) x = random(-5, 5);
    const pose now(q);
    std::array<cd::placed_link, links.size()> placed;
    cd::place_links(links, q, placed);
    const auto wanted = cd::derivatives_of_torques<pose::size, links.size()>(links, placed, dq, ddq, {});
    const auto coriolis = cca::coriolis_matrix(now, dq);
    check("Coriolis matrix", coriolis, cd::coriolis_of<pose::size>(links, placed, dq));
    check("half the derivatives by velocities", decltype(coriolis)(2 * coriolis), wanted.by_velocities);
    const auto found = cca::inverse_dynamics_derivatives(now, dq, ddq);
    check("torques", found.torques, wanted.torques);
    check("by angles", found.by_angles, wanted.by_angles);
    check("by velocities", found.by_velocities, wanted.by_velocities);
    check("by accelerations", found.by_accelerations, wanted.by_accelerations);
  }
}

}  // namespace random_bodies_test

TEST_SUITE("random bodies") {
  TEST_CASE("recordings are as the loops") {
    [&]<int... Seed>(std::integer_sequence<int, Seed...>) {
      static_assert((int{random_bodies_test::is_recorded<Seed>} + ...) >= 8);
      (random_bodies_test::check_body<Seed>(), ...);
    }(std::make_integer_sequence<int, 12>());
  }
}
