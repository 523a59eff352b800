// Forward and inverse kinematics of chains and of Oncilla's leg.
#include <string>

#include <doctest/doctest.h>

#include "chains.hpp"

using namespace mapping_test;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();

template <class Chain, class Tip>
using forward = cca::forward_kinematics<Chain, angles_of<Chain>, Tip>;
template <class Chain, class Tip>
using inverse = cca::inverse_kinematics<Chain, angles_of<Chain>, Tip>;

// Calls the inverse directly, until its search ends.
template <class Ik, class Vector>
auto solve(Ik& ik, const Vector& target) {
  struct {
    cca::output_space<Ik>::vector_type q;
    cca::reaching status = cca::reaching::unfinished;
  } found;
  for (int beat = 0; beat < 1000 && found.status == cca::reaching::unfinished; ++beat) {
    const auto all = laws::map_all(ik, target);
    found.q = std::get<0>(all).vector();
    found.status = static_cast<cca::reaching>(static_cast<int>(std::get<1>(all).vector()[0]));
  }
  return found;
}

template <class Tip>
double apart(const typename Tip::vector_type& a, const typename Tip::vector_type& b) {
  if constexpr (Tip::size == 7)
    return (a.template head<3>() - b.template head<3>()).norm() + std::min((a - b).norm(), (a + b).norm());
  else if constexpr (Tip::size == 4) return std::min((a - b).norm(), (a + b).norm());
  else return (a - b).norm();
}

// For a reachable target the inverse finds angles that lead there.
template <class Chain, class Tip>
struct chain_model {
  using chain = Chain;
  using tip = Tip;
};

// From a reachable foot position to the angles, in closed form, and back.
template <class Leg, class Tip>
struct leg_model {
  using forward = cca::inverse_kinematics<Leg, angles_of<Leg>, Tip>;
  using inverse = cca::forward_kinematics<Leg, angles_of<Leg>, Tip>;
  static auto random(laws::source& r) {
    inverse foot;
    return laws::map(foot, random_angles<Leg>(r));
  }
  static bool close(const typename Tip::vector_type& a, const typename Tip::vector_type& b) {
    return (a - b).norm() < 1e-9;
  }
};

using of_skew_arm = inverse<skew_arm, foot_in_trunk>;
using of_left_leg = inverse<left_leg, foot_in_trunk>;
using of_right_leg = inverse<right_leg, foot_in_trunk>;

struct more : cca::space<cca::joint_angles, cca::axes<a3, a6, a1, a2>> {};
struct other_order : cca::space<cca::joint_angles, cca::axes<a3, a1, a2>> {};

struct free1 : cca::dimension<"a"> {};
struct free2 : cca::dimension<"b"> {};
struct free_arm : cca::serial_chain<trunk, hip, cca::axes<free1, free2>> {
  static constexpr std::array joints{revolute(along_y), revolute(along_y, at(0.3, 0, 0))};
  static constexpr auto tip = at(0.2, 0, 0);
};

struct back : turning<"knee", -180, 0> {};
struct both : turning<"knee", -180, 180> {};
struct hip_angle : turning<"hip", -90, 90> {};
struct backward : cca::pantograph_leg<hip, world, cca::axes<hip_angle, back>, leg_on(1)> {};
struct folding : turning<"knee", 100, 320> {};
struct folding_back : turning<"knee", -320, -100> {};
struct any_hip : turning<"hip", -320, 320> {};
template <class Knee>
struct folding_leg : cca::pantograph_leg<hip, world, cca::axes<any_hip, Knee>, leg_on(1)> {};
struct either : cca::pantograph_leg<hip, world, cca::axes<hip_angle, both>, leg_on(1)> {};

struct foot_in_base_plane : cca::space<cca::cartesian_position<trunk>, cca::axes<cca::x, cca::z>> {};

}  // namespace

// [chain]
namespace reaching_arm {

struct shoulder : cca::dimension<"shoulder"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.5, 1.5}};
};
struct elbow : cca::dimension<"elbow"> {
  static constexpr auto limits = cca::limits{cca::angle{0.1, 2.5}};
};
struct arm : cca::serial_chain<trunk, hip, cca::axes<shoulder, elbow>> {  // from one frame to another
  static constexpr std::array joints{cca::revolute(cca::along_z, cca::at(0.1, 0, 0)),
                                     cca::revolute(cca::along_z, cca::at(0.3, 0, 0))};
  static constexpr auto tip = cca::at(0.25, 0, 0);
};
struct arm_angles : cca::space<cca::joint_angles, cca::axes<shoulder, elbow>> {};
struct hand : cca::space<cca::cartesian_position<trunk>, cca::axes<cca::x, cca::y>> {};

using ik = cca::inverse_kinematics<arm, arm_angles, hand>;  // in "position"; out "angles", "status"

}  // namespace reaching_arm
// [chain end]

TEST_SUITE("kinematics") {
  TEST_CASE("the example of docs/mappings.md") {
    reaching_arm::ik ik;
    const auto near = solve(ik, Eigen::Vector2d(0.4, 0.2));
    CHECK(near.status == cca::reaching::reached);
    CHECK((cca::chain_pose<reaching_arm::arm>(near.q).tip().at - Eigen::Vector3d(0.4, 0.2, 0)).norm() < 1e-8);
    CHECK(solve(ik, Eigen::Vector2d(0.9, 0.2)).status == cca::reaching::nearest);
  }

  TEST_CASE_TEMPLATE("the Jacobian agrees with differences of positions", Chain, plane_arm, skew_arm,
                     sliding_arm, telescope, whole_arm, left_leg, right_leg, leg_in_plane) {
    laws::source random{std::mt19937_64{21}};
    for (int i = 0; i < laws::rounds; ++i) {
      const auto q = random_angles<Chain>(random, 1.2);
      const cca::chain_pose<Chain> now(q);
      for (int k = 0; k < q.size(); ++k) {
        constexpr double h = 1e-6;
        auto before = q, after = q;
        before[k] -= h, after[k] += h;
        const auto a = cca::chain_pose<Chain>(before).tip(), b = cca::chain_pose<Chain>(after).tip();
        const Eigen::Vector3d linear = (b.at - a.at) / (2 * h);
        const Eigen::Matrix3d turn = (b.turn * a.turn.transpose() - Eigen::Matrix3d::Identity()) / (2 * h);
        const Eigen::Vector3d angular(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0),
                                      turn(1, 0) - turn(0, 1));
        CHECK((now.jacobian().col(k).template tail<3>() - linear).norm() < 1e-8);
        CHECK((now.jacobian().col(k).template head<3>() - angular / 2).norm() < 1e-8);
      }
      CHECK((now.tip().turn.transpose() * now.tip().turn - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    }
  }

  TEST_CASE("positions, orientations and poses agree on one tip") {
    laws::source random{std::mt19937_64{22}};
    for (int i = 0; i < laws::rounds; ++i) {
      const auto q = random_angles<whole_arm>(random);
      forward<whole_arm, foot_in_trunk> position;
      forward<whole_arm, foot_in_base_plane> in_plane;
      forward<whole_arm, turn_in_trunk> orientation;
      forward<whole_arm, pose_in_trunk> pose;
      const auto tip = cca::chain_pose<whole_arm>(q).tip();
      CHECK(laws::map(position, q) == tip.at);
      CHECK(laws::map(in_plane, q) == Eigen::Vector2d(tip.at[0], tip.at[2]));
      CHECK((cca::rotation::matrix<double>(laws::map(orientation, q)) - tip.turn).norm() < 1e-14);
      CHECK(laws::map(pose, q).head<3>() == tip.at);
      CHECK(laws::map(pose, q).tail<4>() == laws::map(orientation, q));
    }
  }

  TEST_CASE("the angles may have another order and other axes between") {
    cca::forward_kinematics<skew_arm, more, foot_in_trunk> position;
    CHECK(laws::map(position, Eigen::Vector4d(-0.3, 9, 0.1, 0.2)) ==
          cca::chain_pose<skew_arm>(Eigen::Vector3d(0.1, 0.2, -0.3)).tip().at);

    cca::inverse_kinematics<skew_arm, other_order, foot_in_trunk> ik;
    const Eigen::Vector3d target = cca::chain_pose<skew_arm>(Eigen::Vector3d(0.1, 0.2, -0.3)).tip().at;
    const auto q = solve(ik, target).q;
    CHECK((cca::chain_pose<skew_arm>(Eigen::Vector3d(q[1], q[2], q[0])).tip().at - target).norm() < 1e-9);
  }

  TEST_CASE_TEMPLATE(
      "the inverse reaches reachable targets", Model, chain_model<plane_arm, foot_in_base_plane>,
      chain_model<skew_arm, foot_in_trunk>, chain_model<sliding_arm, foot_in_trunk>,
      chain_model<whole_arm, foot_in_trunk>, chain_model<whole_arm, turn_in_trunk>,
      chain_model<whole_arm, pose_in_trunk>, chain_model<left_leg, foot_in_trunk>,
      chain_model<right_leg, foot_in_trunk>, chain_model<leg_in_plane, foot_in_plane>,
      chain_model<turned_leg, foot_in_trunk>, chain_model<pitched_leg, foot_in_base_plane>,
      chain_model<tilted_leg, foot_in_base_plane>, chain_model<splayed_leg, foot_in_base_plane>,
      chain_model<as_chain<left_leg>, foot_in_trunk>) {
    using chain = typename Model::chain;
    using tip = typename Model::tip;
    laws::source random{std::mt19937_64{23}};
    forward<chain, tip> there;
    int missed = 0;
    for (int i = 0; i < 1000; ++i) {
      inverse<chain, tip> back;  // without any earlier answer
      const auto target = laws::map(there, random_angles<chain>(random));
      const std::size_t before = laws::allocations();
      const auto found = solve(back, target);
      const std::size_t allocated = laws::allocations() - before;
      CHECK(allocated == 0);
      CHECK(within_limits<chain>(found.q));
      CHECK(found.status != cca::reaching::nearest);  // that would say "out of reach"
      if (found.status != cca::reaching::reached) ++missed;
      else CHECK(apart<tip>(laws::map(there, found.q), target) < 2e-8);
    }
    CHECK(missed <= 1);
  }

  TEST_CASE_TEMPLATE("the kinematics of a leg obey the laws of an inverse", Model,
                     leg_model<left_leg, foot_in_trunk>, leg_model<right_leg, foot_in_trunk>,
                     leg_model<leg_in_plane, foot_in_plane>) {
    laws::inverse<Model>();
  }

  TEST_CASE("it follows a path without a jump") {
    inverse<whole_arm, pose_in_trunk> ik;
    forward<whole_arm, pose_in_trunk> there;
    Eigen::Matrix<double, 6, 1> q, from, to;
    from << 0.1, 0.2, -0.8, 0.3, 0.5, -0.2;
    to << 0.9, 0.7, -1.5, -0.4, 0.8, 0.6;
    cca::optional_in<"near", angles_of<whole_arm>> near(from, 0, true);
    near.set_wired();
    auto [first, status] = ik.process(cca::in<"pose", pose_in_trunk>(laws::map(there, from), 0, true), near);
    CHECK((first.vector() - from).norm() < 1e-9);
    q = from;
    for (int i = 1; i <= 200; ++i) {
      const auto found = solve(ik, laws::map(there, (from + i / 200.0 * (to - from)).eval()));
      CHECK(found.status == cca::reaching::reached);
      CHECK((found.q - q).norm() < 0.02);
      q = found.q;
    }
    CHECK((q - to).norm() < 1e-6);
  }

  TEST_CASE("it moves from the stretched arm towards its base") {
    inverse<plane_arm, foot_in_base_plane> ik;
    const auto found = solve(ik, Eigen::Vector2d(0.4, 0));
    CHECK(found.status == cca::reaching::reached);
  }

  TEST_CASE("what it has not reached is told after the run, also where nobody reads the status") {
    inverse<free_arm, foot_in_base_plane> ik;
    CHECK(ik.summary() == "");
    solve(ik, Eigen::Vector2d(0.3, 0.2));
    CHECK(ik.summary() == "");
    solve(ik, Eigen::Vector2d(1.0, 0));
    solve(ik, Eigen::Vector2d(not_a_number, 0));
    const std::string said = ik.summary();
    CAPTURE(said);
    CHECK(said.starts_with("1 times the target was out of reach, "));  // and in each beat of the search
    CHECK(said.find(" times it was not reached yet, the farthest by 0.5 m: see its `status`; ") != said.npos);
    CHECK(said.ends_with("1 times the target was not finite"));
    of_left_leg leg;  // in closed form
    solve(leg, Eigen::Vector3d(0, 0, -9));
    CHECK(leg.summary().starts_with("1 times the target was out of reach, the farthest by 8."));
    ik.on_start();
    CHECK(ik.summary() == "");
  }

  TEST_CASE("it finds the nearest point of a circle") {
    laws::source random{std::mt19937_64{24}};
    for (int i = 0; i < laws::rounds; ++i) {
      inverse<free_arm, foot_in_base_plane> ik;
      const Eigen::Vector2d direction = Eigen::Vector2d(random(-1, 1), random(-1, 1)).normalized();
      for (const double radius : {1e200, 0.5001, 0.6, 2.0, 100.0, 0.05, 0.0999}) {
        const auto found = solve(ik, (radius * direction).eval());
        const auto at = cca::chain_pose<free_arm>(found.q).tip().at;
        CHECK(found.status == cca::reaching::nearest);
        CHECK((Eigen::Vector2d(at[0], at[2]) - (radius > 0.2 ? 0.5 : 0.1) * direction).norm() < 2e-5);
      }
    }
  }

  TEST_CASE_TEMPLATE("a target that is not finite gives the last angles", Ik, of_skew_arm, of_left_leg,
                     of_right_leg) {
    Ik ik;
    const auto before = solve(ik, Eigen::Vector3d(0.15, 0.1, -0.16)).q;
    for (const double bad : {not_a_number, inf, -inf})
      for (int i = 0; i < 3; ++i) {
        Eigen::Vector3d target(0.1, 0.1, -0.1);
        target[i] = bad;
        const auto found = solve(ik, target);
        CHECK(found.status == cca::reaching::unreadable);
        CHECK(found.q == before);
      }
    for (const double far : {0.0, 1e-300, 1e6, 1e150, 1e300, -1e308})
      for (const Eigen::Vector3d& direction :
           {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0.3, -1, -1)}) {
        const auto found = solve(ik, (far * direction).eval());
        CHECK(found.q.allFinite());
        CHECK(found.status != cca::reaching::unreadable);
        CHECK(found.status != cca::reaching::nothing);
      }
  }

  TEST_CASE("a start that is not finite is ignored") {
    of_skew_arm ik, other;
    const auto q = solve(ik, Eigen::Vector3d(0.4, 0.1, 0.3)).q;
    (void)solve(other, Eigen::Vector3d(0.4, 0.1, 0.3));
    cca::optional_in<"near", angles_of<skew_arm>> near(Eigen::Vector3d(not_a_number, inf, q[2]), 0, true);
    near.set_wired();
    const Eigen::Vector3d next(0.3, 0.2, 0.3);
    const auto [angles, status] = ik.process(cca::in<"position", foot_in_trunk>(next, 0, true), near);
    CHECK(angles.vector() == solve(other, next).q);
  }

  TEST_CASE("a start beyond the limits is moved to the nearest angles within") {
    const Eigen::Vector3d beyond(2.0, 0.1, -0.3);
    cca::optional_in<"near", angles_of<skew_arm>> near(beyond, 0, true);
    near.set_wired();
    of_skew_arm ik;
    const auto [q, status] = ik.process(
        cca::in<"position", foot_in_trunk>(cca::chain_pose<skew_arm>(beyond).tip().at, 0, true), near);
    CHECK(within_limits<skew_arm>(q.vector()));
  }

  TEST_CASE("after on_start earlier answers have no effect") {
    of_skew_arm used, fresh;
    (void)solve(used, Eigen::Vector3d(0.4, 0.1, 0.3));
    used.on_start();
    const Eigen::Vector3d nowhere = Eigen::Vector3d::Constant(not_a_number);
    CHECK(solve(used, nowhere).q == solve(fresh, nowhere).q);
  }

  TEST_CASE(
      "sections that slide together move by their ratios from their rest positions, within their limits") {
    CHECK(cca::chain_pose<telescope>(Eigen::Vector2d(0, 0.1)).tip().at[0] ==
          doctest::Approx(0.3 + 0.1 + 0.05 + 0.02));
    inverse<telescope, foot_in_trunk> ik;
    CHECK(solve(ik, Eigen::Vector3d(9, 0, 0)).q[1] == 0.3);
    CHECK(solve(ik, Eigen::Vector3d(0.1, 0, 0)).q[1] == -0.1);
  }

  TEST_CASE("a quaternion of any length means the same rotation") {
    const auto target = [](double length) {
      forward<whole_arm, pose_in_trunk> there;
      auto pose = laws::map(there, Eigen::Matrix<double, 6, 1>{0.1, 0.2, -0.8, 0.3, 0.5, -0.2});
      pose.tail<4>() *= length;
      return pose;
    };
    inverse<whole_arm, pose_in_trunk> unit;
    const auto q = solve(unit, target(1)).q;
    for (const double length : {1e-200, 3.0, 1e200}) {
      inverse<whole_arm, pose_in_trunk> ik;
      CHECK((solve(ik, target(length)).q - q).norm() < 1e-6);
    }
  }
}

TEST_SUITE("Oncilla's leg") {
  TEST_CASE("its kinematics are those of the simulator") {
    laws::source random{std::mt19937_64{25}};
    for (int i = 0; i < laws::rounds; ++i) {
      const auto q = random_angles<leg_in_plane>(random);
      const auto foot = cca::sim::foot_position(oncilla, {q[0], q[1]});
      const auto tip = cca::chain_pose<leg_in_plane>(q).tip().at;
      CHECK((tip - Eigen::Vector3d(foot.x, 0, foot.z)).norm() < 1e-15);
      inverse<leg_in_plane, foot_in_plane> ik;
      const auto angles = cca::sim::leg_angles_for(oncilla, foot);
      CHECK((solve(ik, Eigen::Vector2d(foot.x, foot.z)).q - Eigen::Vector2d(angles.hip, angles.knee)).norm() <
            1e-7);
      // The abduction turns the plane outward about x.
      for (const double side : {1.0, -1.0}) {
        const double tilt = side * random(-0.3, 0.3);
        const Eigen::Vector3d a(side * tilt, q[0], q[1]);
        const Eigen::Vector3d expected =
            Eigen::Vector3d(oncilla.hip_x, side * oncilla.hip_y, -0.02) +
            Eigen::Vector3d(foot.x, -foot.z * std::sin(tilt), foot.z * std::cos(tilt));
        const auto at =
            side > 0 ? cca::chain_pose<left_leg>(a).tip().at : cca::chain_pose<right_leg>(a).tip().at;
        CHECK((at - expected).norm() < 1e-15);
      }
    }
  }

  // Out of reach: no angles of a fine grid lead nearer.
  TEST_CASE_TEMPLATE("no reachable point is nearer", Leg, left_leg, right_leg) {
    laws::source random{std::mt19937_64{26}};
    const double side = std::is_same_v<Leg, left_leg> ? 1 : -1;
    std::vector<Eigen::Vector3d> grid;
    using limits = cca::detail::chain_limits<Leg, angles_of<Leg>>;
    for (int a = 0; a <= 16; ++a)
      for (int h = 0; h <= 60; ++h)
        for (int k = 0; k <= 60; ++k) {
          const Eigen::Vector3d q(limits::between(0, a / 16.0), limits::between(1, h / 60.0),
                                  limits::between(2, k / 60.0));
          grid.push_back(cca::chain_pose<Leg>(q).tip().at);
        }
    int outside = 0, above = 0;
    for (int i = 0; i < 300; ++i) {
      const Eigen::Vector3d target =
          Eigen::Vector3d(oncilla.hip_x, side * oncilla.hip_y, -0.02) + random.vector(0.3);
      inverse<Leg, foot_in_trunk> ik;
      const auto found = solve(ik, target);
      CHECK(within_limits<Leg>(found.q));
      const double distance = (cca::chain_pose<Leg>(found.q).tip().at - target).norm();
      double nearest = inf;
      for (const auto& p : grid) nearest = std::min(nearest, (p - target).norm());
      CHECK(distance <= nearest + 1e-12);
      CHECK((found.status == cca::reaching::reached) == (distance < 1e-9));
      outside += distance > 1e-9;
      above += target[2] > 0 && distance > 1e-9;
      // The general solver agrees to a micrometre.
      inverse<as_chain<Leg>, foot_in_trunk> general;
      const auto other = solve(general, target);
      const double general_distance = (cca::chain_pose<Leg>(other.q).tip().at - target).norm();
      CHECK(general_distance >= distance - 1e-9);
      CHECK(general_distance <= distance + 1e-6);
    }
    CHECK(outside > 100);
    CHECK(above > 50);
  }

  TEST_CASE_TEMPLATE("for a target nearer to the hip than the leg can fold, it folds", Knee, folding,
                     folding_back) {
    const double shortest = std::abs(oncilla.upper_length + oncilla.foot_lever() - oncilla.middle_length);
    inverse<folding_leg<Knee>, foot_in_plane> ik;
    const Eigen::Vector2d target = 0.5 * shortest * Eigen::Vector2d(0.6, -0.8);
    const auto at = cca::chain_pose<folding_leg<Knee>>(solve(ik, target).q).tip().at;
    CHECK((Eigen::Vector2d(at[0], at[2]) - 2 * target).norm() < 1e-9);
  }

  // A knee that bends both ways, as in the leg of the README.
  TEST_CASE("a knee with negative angles, and one with both signs") {
    laws::source random{std::mt19937_64{27}};
    for (int i = 0; i < laws::rounds; ++i) {
      const auto q = random_angles<backward>(random);
      forward<backward, foot_in_plane> there;
      const auto foot = laws::map(there, q);
      inverse<backward, foot_in_plane> ik;
      const auto found = solve(ik, foot);
      CHECK(found.status == cca::reaching::reached);
      CHECK((laws::map(there, found.q) - foot).norm() < 1e-9);
      // Of two solutions the one nearer to the current angles.
      inverse<either, foot_in_plane> one;
      cca::optional_in<"near", angles_of<either>> near(q, 0, true);
      near.set_wired();
      const auto [angles, status] = one.process(cca::in<"position", foot_in_plane>(foot, 0, true), near);
      CHECK((angles.vector() - q).norm() < 1e-6);
    }
  }
}
