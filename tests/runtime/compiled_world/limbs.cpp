// The limbs of a compiled world: which share their code, and that the results do not depend on how many are
// computed at once.
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

}  // namespace

TEST_SUITE("compiled world: limbs") {
  TEST_CASE("legs of one shape share their code; a limb of many links is computed in loops") {
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
