// What is recorded (robot/recorded/) against the loops over the links, which larger bodies use: the same
// numbers to 1e-12 of the largest entry, a number that is NaN or infinite does not come out finite, and what
// is too large is not recorded.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include <cca/robot/dynamics/coriolis_matrix.hpp>
#include <cca/robot/dynamics/forward_dynamics.hpp>
#include <cca/robot/dynamics/momentum.hpp>
#include <cca/robots/oncilla/legged_body.hpp>

#include "../../laws/space_laws.hpp"
#include "bodies.hpp"
#include "recorded_bodies.hpp"

using namespace body_test;
namespace cd = cca::detail;

namespace {

// So many operations, of one input.
template <int Operations>
struct powers {
  static constexpr std::array sizes{1}, results{1};
  static constexpr bool is_small = true;
  static constexpr int group(int input) { return input; }
  static constexpr int owner(int) { return -1; }
  static constexpr bool may_vanish(int) { return false; }
  static constexpr void record(cd::recorder& r) {
    cd::recorded x = r.input(0);
    for (int i = 0; i < Operations; ++i) x = x * r.input(0);
    r.output(x);
  }
};
static_assert(cd::most_kept_operations == 2300);
static_assert(cd::tape_of<powers<cd::most_kept_operations>>.operations == cd::most_kept_operations);
static_assert(cd::is_recorded<powers<cd::most_kept_operations>>());
static_assert(!cd::is_recorded<powers<cd::most_kept_operations + 1>>());
static_assert(!cd::is_recorded<powers<cd::most_operations + 1>>());  // more than the recorder holds

// On both sides of the limit.
using oncilla = cca::robots::oncilla::legged_body;
static_assert(cd::tape_of<cd::recorded_floating_forward_dynamics<oncilla>>.operations > 2000);
static_assert(cd::is_recorded<cd::recorded_floating_forward_dynamics<oncilla>>());
static_assert(cd::is_recorded<cd::recorded_forward_dynamics<random_tree_body, false>>());
static_assert(!cd::is_recorded<cd::recorded_forward_dynamics<random_tree_body, true>>());
static_assert(!cd::is_recorded<cd::recorded_floating_forward_dynamics<random_tree_body>>());
static_assert(!cd::is_recorded<cd::recorded_inverse_dynamics<humanoid, false>>());

// A state, and everything at it: by the library, and by the loops, of sines of the C library.
template <class Body>
struct everything {
  static constexpr int n = cca::axes_of<Body>::count;
  static constexpr const auto& links = cd::weighed_links_of<Body>;
  static constexpr std::size_t count = links.size();
  static constexpr std::size_t part = Body::attached::count - 1;
  static constexpr bool coupled = cd::has_coupled_joints(links);
  using vector = Eigen::Matrix<double, n, 1>;
  using matrix = Eigen::Matrix<double, n, n>;

  vector q, dq, input;
  cca::base_motion base;
  Eigen::Matrix<double, 6, 1> wrench;

  struct result {
    vector inverse, standing, gravity, upright, coriolis, forward, held, momentum, change;
    Eigen::Matrix<double, 6, 1> on_base, on_standing;
    Eigen::Matrix<double, n + 6, 1> floating;
    matrix mass, coriolis_matrix;
    Eigen::Matrix<double, n + 6, n + 6> floating_mass;
    Eigen::Matrix<double, 6, n> jacobian;
    cca::matrix3 turn;
    Eigen::Vector3d at, centre;

    template <class Visit>
    static void each(const result& a, const result& b, Visit visit) {
      visit("inverse dynamics", a.inverse, b.inverse);
      visit("wrench on the base", a.on_base, b.on_base);
      visit("inverse dynamics of a base that stands", a.standing, b.standing);
      visit("wrench on a base that stands", a.on_standing, b.on_standing);
      visit("gravity", a.gravity, b.gravity);
      visit("gravity of a base that stands", a.upright, b.upright);
      visit("Coriolis torques", a.coriolis, b.coriolis);
      visit("Coriolis matrix", a.coriolis_matrix, b.coriolis_matrix);
      visit("mass matrix", a.mass, b.mass);
      visit("mass matrix with the base", a.floating_mass, b.floating_mass);
      visit("forward dynamics", a.forward, b.forward);
      visit("forward dynamics of a base that stands", a.held, b.held);
      visit("forward dynamics of a free base", a.floating, b.floating);
      visit("momentum", a.momentum, b.momentum);
      visit("change of momentum", a.change, b.change);
      visit("Jacobian", a.jacobian, b.jacobian);
      visit("orientation", a.turn, b.turn);
      visit("position", a.at, b.at);
      visit("centre of mass", a.centre, b.centre);
    }
  };

  template <cca::fixed_string Name, class Chain, class Nodes>
  static void take_end(result& r,
                       const cca::body_pose<Body>& now,
                       std::type_identity<cca::part<Name, Chain, Nodes>>) {
    const cca::rigid tip = now.template tip<Name>();
    r.turn = tip.turn, r.at = tip.at;
    r.jacobian = now.template jacobian<Name>();
  }
  template <class Forward>
  static void take(result& r, const Forward& f) {
    r.floating << f.accelerations, f.base.angular_acceleration, f.base.acceleration;
  }

  result by_library() const {
    result r;
    const cca::body_pose<Body> now(q);
    const auto inverse = cca::inverse_dynamics(now, dq, input, base),
               standing = cca::inverse_dynamics(now, dq, input);
    r.inverse = inverse.torques, r.on_base = inverse.wrench;
    r.standing = standing.torques, r.on_standing = standing.wrench;
    r.gravity = cca::gravity_torques(now, base.gravity), r.upright = cca::gravity_torques(now);
    r.coriolis = cca::coriolis_torques(now, dq), r.coriolis_matrix = cca::coriolis_matrix(now, dq);
    r.mass = cca::mass_matrix(now), r.floating_mass = cca::floating_mass_matrix(now);
    r.forward = cca::forward_dynamics(now, dq, input, base), r.held = cca::forward_dynamics(now, dq, input);
    take(r, cca::floating_forward_dynamics(now, dq, input, base, wrench));
    const auto momentum = cca::joint_momentum(now, dq);
    r.momentum = momentum.momentum, r.change = momentum.change;
    take_end(r, now, std::type_identity<std::tuple_element_t<part, typename Body::parts>>());
    r.centre = now.centre_of_mass();
    return r;
  }
  result by_loops() const {
    result r;
    std::array<cd::placed_link, count> placed;
    cd::place_links(links, q, placed);
    constexpr cca::link_inertia of_base = cd::base_inertia_of<Body>();
    const auto inverse = cd::newton_euler<count, n>(links, placed, of_base, dq, input, base),
               standing = cd::newton_euler<count, n>(links, placed, of_base, dq, input, {});
    r.inverse = inverse.torques, r.on_base = inverse.wrench;
    r.standing = standing.torques, r.on_standing = standing.wrench;
    r.gravity = cd::torques_at_rest<n>(links, placed, base.gravity);
    r.upright = cd::torques_at_rest<n>(links, placed, cca::base_motion{}.gravity);
    cca::base_motion weightless;
    weightless.gravity.setZero();
    const vector zero = vector::Zero();
    r.coriolis = cd::newton_euler<count, n>(links, placed, of_base, dq, zero, weightless).torques;
    r.coriolis_matrix = cd::coriolis_of<n>(links, placed, dq);
    r.mass = cd::joint_space_inertia<n>(links, cd::composite_bodies<count>(links, placed, {}));
    r.floating_mass = cd::whole_inertia<n>(links, cd::composite_bodies<count>(links, placed, of_base));
    if constexpr (coupled) {
      const auto held = [&](const cca::base_motion& b) {
        const vector bias = cd::newton_euler<count, n>(links, placed, of_base, dq, zero, b).torques;
        return cd::positive_matrix<n>(r.mass).solve(vector(input - bias));
      };
      r.forward = held(base), r.held = held({});
      cca::base_motion still = base;
      still.angular_acceleration.setZero(), still.acceleration.setZero();
      const auto bias = cd::newton_euler<count, n>(links, placed, of_base, dq, zero, still);
      Eigen::Matrix<double, 6 + n, 1> load;
      load << wrench - bias.wrench, input - bias.torques;
      load = cd::positive_matrix<6 + n>(r.floating_mass).solve(load);
      r.floating << load.template tail<n>(), load.template head<6>();
    } else {
      const cd::vector6 none = cd::vector6::Zero();
      r.forward = cd::articulated_body<false>(links, placed, {}, dq, input, base, none).accelerations;
      r.held =
          cd::articulated_body<false>(links, placed, {}, dq, input, cca::base_motion{}, none).accelerations;
      take(r, cd::articulated_body<true>(links, placed, of_base, dq, input, base, wrench));
    }
    const auto momentum = cd::momentum_of_joints<n>(links, placed, dq);
    r.momentum = momentum.momentum, r.change = momentum.change;
    constexpr auto end = cd::body_tree_of<Body>.ends[part];
    const cca::rigid tip = placed[static_cast<std::size_t>(end.link)].frame * end.where;
    cd::fill_jacobian(links, placed, end.link, tip.at, r.jacobian);
    r.turn = tip.turn, r.at = tip.at;
    r.centre = cd::centre_of_mass(links, placed, of_base);
    return r;
  }
};

template <class Body>
everything<Body> random_state_of(laws::source& random) {
  everything<Body> s;
  for (auto& x : s.q) x = random(-3, 3);
  for (auto& x : s.dq) x = random(-2, 2);
  for (auto& x : s.input) x = random(-5, 5);
  s.base = {random.vector(10), random.vector(2), random.vector(3), random.vector(5)};
  s.wrench << random.vector(3), random.vector(5);
  return s;
}

// What is not finite by the loops, of a state with one number that is not.
template <class Body>
void check_not_finite(const everything<Body>& s, bool with_forward) {
  using result = typename everything<Body>::result;
  result::each(s.by_library(), s.by_loops(), [&](const char* what, const auto& a, const auto& b) {
    if (!with_forward && std::string_view(what).starts_with("forward")) return;
    INFO(what);
    int lost = 0;
    for (int k = 0; k < a.size(); ++k) lost += std::isfinite(a.data()[k]) && !std::isfinite(b.data()[k]);
    CHECK(lost == 0);
  });
}

}  // namespace

TEST_SUITE("recorded dynamics") {
  TEST_CASE_TEMPLATE("the numbers of the loops", Body, arm, hound, cca::robots::oncilla::legged_body,
                     random_tree_body, humanoid) {
    laws::source random{std::mt19937_64{81}};
    for (int round = 0; round < 50; ++round) {
      const auto s = random_state_of<Body>(random);
      const auto a = s.by_library(), b = s.by_loops();
      everything<Body>::result::each(a, b, [](const char* what, const auto& x, const auto& y) {
        INFO(what);
        CHECK((x - y).cwiseAbs().maxCoeff() <= 1e-12 * y.cwiseAbs().maxCoeff());
      });
    }
  }

  TEST_CASE_TEMPLATE("a number that is not finite does not come out finite", Body, arm, hound,
                     random_tree_body) {
    laws::source random{std::mt19937_64{82}};
    const auto s = random_state_of<Body>(random);
    constexpr bool coupled = everything<Body>::coupled;
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
      for (int k = 0; k < everything<Body>::n; ++k) {
        INFO("coordinate ", k);
        auto changed = s;
        changed.q[k] = bad;
        check_not_finite(changed, !coupled);
        changed = s, changed.dq[k] = bad;
        check_not_finite(changed, !coupled);
        changed = s, changed.input[k] = bad;
        check_not_finite(changed, !coupled);
      }
      for (int k = 0; k < 3; ++k) {
        INFO("of the base ", k);
        auto changed = s;
        changed.base.gravity[k] = bad;
        check_not_finite(changed, !coupled);
        changed = s, changed.base.angular_velocity[k] = bad;
        check_not_finite(changed, !coupled);
        changed = s, changed.base.acceleration[k] = bad;
        check_not_finite(changed, !coupled);
        changed = s, changed.base.angular_acceleration[k] = bad;
        check_not_finite(changed, !coupled);
        changed = s, changed.wrench[k] = bad, changed.wrench[3 + k] = bad;
        check_not_finite(changed, !coupled);
      }
    }
  }
}
