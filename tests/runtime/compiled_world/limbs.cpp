// The limbs of a compiled world: which share their code, and that the results do not depend on how many are
// computed at once.
#include <algorithm>

#include <doctest/doctest.h>

#include "../body/bodies.hpp"
#include "../body/recorded_bodies.hpp"
#include "../dual.hpp"
#include "robots.hpp"

using namespace compiled_test;
using test::dual;

namespace {

// The state of a thrown Oncilla after 50 beats. Dual numbers take one limb after the other.
template <class Real>
auto thrown() {
  sim::compiled_world<flying_oncilla, Real> w;
  std::array<Real, 16> q{}, dq{};
  for (std::size_t c = 0; c < q.size(); ++c) {
    const auto x = static_cast<double>(c);
    q[c] = Real(0.3 * std::sin(7 * x)), dq[c] = Real(2 * std::cos(3 * x));
  }
  w.place(q, dq, cca::at(0.1, 0.2, 0.3), {Real(0.5), Real(-1.0), Real(1.5)},
          {Real(1.0), Real(0.5), Real(0.0)});
  for (int i = 0; i < 50; ++i) w.advance({});
  return w.save().motion;
}

// A spring couples two legs, so their rows meet in M, where the legs have no mass in common.
struct sprung_legs : flying_oncilla {
  static constexpr std::array line_springs{
      robots::line_spring{.from = robots::oncilla::detail::diagonal_spring("left_front_leg").from,
                          .to = robots::oncilla::detail::diagonal_spring("right_front_leg").to,
                          .stiffness = 100,
                          .rest = 0.1}};
};

// Of the entries of M, in a posture, those that are 0; what was there before does not count.
template <class R>
int zeros_of_mass() {
  std::array<double, 16> q{};
  for (std::size_t c = 0; c < q.size(); ++c) q[c] = 0.3 * std::sin(7.0 * static_cast<double>(c) + 1);
  sim::detail::tree_equations<R, double> now;
  now.mass.entry.fill(1);
  now.look(q);
  now.weigh({}, {}, {});
  return static_cast<int>(std::count(now.mass.entry.begin(), now.mass.entry.end(), 0.0));
}

}  // namespace

TEST_SUITE("compiled world: limbs") {
  TEST_CASE("legs that a spring couples have no mass in common") {
    constexpr int more = sim::detail::compiled_tree<sprung_legs>::branches.entries -
                         sim::detail::compiled_tree<flying_oncilla>::branches.entries;
    static_assert(more > 0);
    CHECK(zeros_of_mass<sprung_legs>() == zeros_of_mass<flying_oncilla>() + more);
  }

  TEST_CASE("legs of one shape share their code - a limb of many links is computed in loops") {
    using oncilla = sim::detail::shared_limbs<flying_oncilla>;
    static_assert(oncilla::leader == std::array<std::size_t, 4>{0, 0, 0, 0});
    static_assert(oncilla::is_recorded<0>);
    using person = sim::detail::shared_limbs<alone<body_test::humanoid, true>>;
    static_assert(person::is_recorded<0> && !person::is_recorded<2>);
  }

  TEST_CASE("the same bits for one limb at once or several") {
    const auto several = thrown<double>();
    const auto one = thrown<dual>();
    bool same = true;
    for (std::size_t c = 0; c < several.q.size(); ++c)
      same = same && several.q[c] == one.q[c].value && several.dq[c] == one.dq[c].value;
    for (std::size_t k = 0; k < 3; ++k)
      same = same && several.at[k] == one.at[k].value &&
             several.angular_velocity[k] == one.angular_velocity[k].value;
    CHECK(same);
    CHECK(several.q[2] != 0.3 * std::sin(14.0));  // it moves
  }
}
