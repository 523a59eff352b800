// The search of inverse kinematics: arms of seven joints with limits, from a cold start, along paths and out
// of reach.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include <Eigen/Dense>

#include "chains.hpp"

using namespace mapping_test;

namespace {

// The geometry and the limits of a Franka Emika Panda, and of a KUKA LBR iiwa 14 with a tool of 50 mm.
namespace panda {
struct q1 : turning<"q1", -289, 289> {};
struct q2 : turning<"q2", -176, 176> {};
struct q3 : turning<"q3", -289, 289> {};
struct q4 : turning<"q4", -307, -7> {};
struct q5 : turning<"q5", -289, 289> {};
struct q6 : turning<"q6", -1, 375> {};
struct q7 : turning<"q7", -289, 289> {};
struct arm : cca::serial_chain<trunk, hip, cca::axes<q1, q2, q3, q4, q5, q6, q7>> {
  static constexpr auto up = turned_about(along_x, std::numbers::pi / 2),
                        down = turned_about(along_x, -std::numbers::pi / 2);
  static constexpr std::array joints{revolute(along_z, at(0, 0, 0.333)),
                                     revolute(along_z, down),
                                     revolute(along_z, at(0, -0.316, 0) * up),
                                     revolute(along_z, at(0.0825, 0, 0) * up),
                                     revolute(along_z, at(-0.0825, 0.384, 0) * down),
                                     revolute(along_z, up),
                                     revolute(along_z, at(0.088, 0, 0) * up)};
  static constexpr auto tip = at(0, 0, 0.107);
};
}  // namespace panda

namespace iiwa {
struct q1 : turning<"q1", -296, 296> {};
struct q2 : turning<"q2", -209, 209> {};
struct q3 : turning<"q3", -296, 296> {};
struct q4 : turning<"q4", -209, 209> {};
struct q5 : turning<"q5", -296, 296> {};
struct q6 : turning<"q6", -209, 209> {};
struct q7 : turning<"q7", -305, 305> {};
struct arm : cca::serial_chain<trunk, hip, cca::axes<q1, q2, q3, q4, q5, q6, q7>> {
  static constexpr std::array joints{revolute(along_z, at(0, 0, 0.36)), revolute(along_y),
                                     revolute(along_z, at(0, 0, 0.42)), revolute({0, -1, 0}),
                                     revolute(along_z, at(0, 0, 0.4)),  revolute(along_y),
                                     revolute(along_z, at(0, 0, 0.126))};
  static constexpr auto tip = at(0, 0, 0.05);
};
}  // namespace iiwa

template <class Chain, class Tip>
struct arm_model {
  using chain = Chain;
  using tip = Tip;
  using ik = cca::inverse_kinematics<Chain, angles_of<Chain>, Tip>;
  using forward = cca::forward_kinematics<Chain, angles_of<Chain>, Tip>;
  using limits = cca::detail::chain_limits<Chain, angles_of<Chain>>;
  using vector = typename limits::vector;
  using target = typename Tip::vector_type;

  static target at(const vector& q) {
    forward there;
    return laws::map(there, q);
  }
  // m; an angle of 1 rad counts as 0.1 m.
  static double distance(const vector& q, const target& wanted) { return error(q, wanted).norm(); }
  static auto error(const vector& q, const target& wanted) {
    const target actual = at(q);
    Eigen::Matrix<double, Tip::size == 7 ? 6 : 3, 1> e;
    e.template head<3>() = wanted.template head<3>() - actual.template head<3>();
    if constexpr (Tip::size == 7) {
      const auto quaternion = [](const target& t) { return Eigen::Quaterniond(t[6], t[3], t[4], t[5]); };
      const Eigen::AngleAxisd turn(quaternion(wanted) * quaternion(actual).conjugate());
      e.template tail<3>() = 0.1 * std::remainder(turn.angle(), 2 * std::numbers::pi) * turn.axis();
    }
    return e;
  }
};

using panda_pose = arm_model<panda::arm, pose_in_trunk>;
using iiwa_pose = arm_model<iiwa::arm, pose_in_trunk>;
using panda_position = arm_model<panda::arm, foot_in_trunk>;

struct few_steps : cca::damped_least_squares {
  static constexpr int steps_per_beat = 17;
};

// One beat.
template <class Ik, class Vector>
auto one_beat(Ik& ik, const Vector& target) {
  const std::size_t before = laws::allocations();
  const auto [angles, status] = laws::map_all(ik, target);
  CHECK(laws::allocations() == before);
  struct {
    cca::output_space<Ik>::vector_type q;
    cca::reaching status;
  } found{angles.vector(), static_cast<cca::reaching>(static_cast<int>(status.vector()[0]))};
  return found;
}

// Beats until the search ends.
template <class Ik, class Vector>
auto all_beats(Ik& ik, const Vector& target, int& beats) {
  auto found = one_beat(ik, target);
  for (beats = 1; beats < 1000 && found.status == cca::reaching::unfinished; ++beats)
    found = one_beat(ik, target);
  return found;
}

// An optimiser of its own to compare with: many random starts, Jacobians by differences, Levenberg and
// Marquardt's method over the joints that no limit blocks. Returns the least distance.
template <class Model>
double least_distance(const typename Model::target& wanted, int starts, laws::source& random) {
  using limits = typename Model::limits;
  constexpr int n = limits::size;
  double least = 1e9;
  for (int s = 0; s < starts; ++s) {
    typename Model::vector q = random_angles<typename Model::chain>(random);
    auto e = Model::error(q, wanted);
    double damping = 1e-2, before = e.squaredNorm();
    for (int i = 0; i < 60; ++i) {
      Eigen::Matrix<double, decltype(e)::RowsAtCompileTime, n> j;
      for (int k = 0; k < n; ++k) {
        auto moved = q;
        moved[k] += 1e-7;
        j.col(k) = (Model::error(moved, wanted) - e) / 1e-7;
      }
      for (int k = 0; k < n; ++k) {
        const double gradient = j.col(k).dot(e);
        if ((q[k] <= limits::lower(k) && gradient > 0) || (q[k] >= limits::upper(k) && gradient < 0))
          j.col(k).setZero();
      }
      const Eigen::Matrix<double, n, n> normal =
          j.transpose() * j + damping * Eigen::Matrix<double, n, n>::Identity();
      const typename Model::vector next = limits::clamped(q - normal.ldlt().solve(j.transpose() * e));
      const auto there = Model::error(next, wanted);
      if (there.squaredNorm() < e.squaredNorm()) q = next, e = there, damping *= 0.3;
      else damping *= 8;
      if (damping > 1e6 || e.norm() < 1e-9) break;
      if (i % 15 == 14) {
        if (e.squaredNorm() > 0.9 * before && e.norm() > least) break;
        before = e.squaredNorm();
      }
    }
    least = std::min(least, e.norm());
    if (least < 1e-9) break;
  }
  return least;
}

}  // namespace

TEST_SUITE("search of inverse kinematics") {
  // For a target that can be reached, no status says that it can't.
  TEST_CASE_TEMPLATE("from a cold start an arm of seven joints reaches 999 of 1000 targets", Model,
                     panda_pose, iiwa_pose, panda_position) {
    laws::source random{std::mt19937_64{31}};
    int called_out_of_reach = 0, not_ended = 0, most_beats = 0, in_first_beat = 0;
    for (int i = 0; i < 1000; ++i) {
      const auto target = Model::at(random_angles<typename Model::chain>(random));
      typename Model::ik ik;
      int beats = 0;
      const auto found = all_beats(ik, target, beats);
      most_beats = std::max(most_beats, beats);
      in_first_beat += beats == 1;
      CHECK(within_limits<typename Model::chain>(found.q));
      called_out_of_reach += found.status == cca::reaching::nearest;
      not_ended += found.status == cca::reaching::unfinished;
      CHECK(found.status != cca::reaching::unreadable);
      if (found.status == cca::reaching::reached) CHECK(Model::distance(found.q, target) < 1e-8);
    }
    MESSAGE(called_out_of_reach, " called out of reach, ", not_ended, " without an end; ", in_first_beat,
            " in the first beat, all within ", most_beats, " beats");
    CHECK(called_out_of_reach == 0);  // "out of reach" is said only when it is true
    CHECK(not_ended <= 1);
  }

  // The search waits: it counts the same starts as one without the broken beats, and ends in the same angles.
  TEST_CASE_TEMPLATE("a target that is NaN or infinite in the middle of a search only delays it", Model,
                     panda_pose, iiwa_pose, panda_position) {
    laws::source random{std::mt19937_64{38}};
    const double broken[] = {std::nan(""), cca::infinity, -cca::infinity};
    int continued = 0, out_of_reach = 0;
    for (int i = 0; i < 200 && (continued < 20 || out_of_reach < 5); ++i) {
      auto target = Model::at(random_angles<typename Model::chain>(random));
      if (i % 4 == 0) target.template head<3>() *= 2.5;
      typename Model::ik disturbed, undisturbed;
      int beats = 0;
      for (; beats < 1000; ++beats) {
        const auto found = one_beat(disturbed, target), wanted = one_beat(undisturbed, target);
        REQUIRE(found.q == wanted.q);
        REQUIRE(found.status == wanted.status);
        if (found.status != cca::reaching::unfinished) {
          out_of_reach += beats > 0 && found.status == cca::reaching::nearest;
          break;
        }
        auto none = target;
        for (int k = 0; k <= beats % 3; ++k) {
          none[(beats + k) % Model::tip::size] = broken[(beats + i) % 3];
          const auto waits = one_beat(disturbed, none);
          CHECK(waits.status == cca::reaching::unreadable);
          CHECK(waits.q == found.q);  // the angles of the last beat, which are finite
        }
      }
      continued += beats > 0;
    }
    MESSAGE(continued, " searches over several beats, ", out_of_reach, " of them out of reach");
    CHECK(continued >= 20);
    CHECK(out_of_reach >= 5);
  }

  TEST_CASE_TEMPLATE("out of reach it finds the nearest point", Model, panda_pose, iiwa_pose,
                     panda_position) {
    laws::source random{std::mt19937_64{32}};
    int outside = 0, most_beats = 0;
    double worst = 0;
    for (int i = 0; i < 15; ++i) {
      typename Model::target target = Model::at(random_angles<typename Model::chain>(random));
      target.template head<3>() = random.vector(1.4);
      typename Model::ik ik;
      int beats = 0;
      const auto found = all_beats(ik, target, beats);
      most_beats = std::max(most_beats, beats);
      CHECK(found.status != cca::reaching::unfinished);
      if (found.status == cca::reaching::reached) continue;
      ++outside;
      const double least = least_distance<Model>(target, 120, random);
      CHECK(least > 1e-6);  // `nearest` is true
      worst = std::max(worst, Model::distance(found.q, target) - least);
    }
    MESSAGE(outside, " targets out of reach, ", 1000 * worst, " mm from the nearest point, within ",
            most_beats, " beats");
    CHECK(worst < 1e-3);
    CHECK(outside > 10);
  }

  TEST_CASE_TEMPLATE("along a path every beat reaches its target", Model, panda_pose, iiwa_pose) {
    laws::source random{std::mt19937_64{33}};
    using limits = typename Model::limits;
    typename Model::vector from = random_angles<typename Model::chain>(random, 0.8), to = from;
    typename Model::ik ik;
    int missed = 0, beats = 0;
    for (int i = 0; i < 5000; ++i) {
      if (i % 250 == 0) from = to, to = random_angles<typename Model::chain>(random, 0.8);
      const auto target = Model::at(from + (i % 250 + 1) / 250.0 * (to - from));
      if (i % 250 == 0) (void)all_beats(ik, target, beats);  // a path may begin anywhere
      cca::optional_in<"near", angles_of<typename Model::chain>> near(from + (i % 250) / 250.0 * (to - from),
                                                                      0, true);
      near.set_wired();
      const auto [angles, status] = ik.process(cca::in<"pose", pose_in_trunk>(target, 0, true), near);
      missed += !status.vector().isConstant(cca::status_of(cca::reaching::reached));
    }
    CHECK(missed == 0);
    static_assert(limits::size == 7);
  }

  TEST_CASE("no beat takes more steps than the settings say") {
    using model = panda_pose;
    laws::source random{std::mt19937_64{34}};
    cca::detail::many_starts<panda::arm, angles_of<panda::arm>, pose_in_trunk, few_steps> search;
    int most = 0, reached = 0;
    for (int i = 0; i < 100; ++i) {
      auto target = model::at(random_angles<panda::arm>(random));
      if (i % 3 == 0) target.head<3>() *= 3;
      for (int beat = 0; beat < 200; ++beat) {
        if (i % 2 == 0) target[0] += 1e-5;  // it moves
        const auto found = search.solve(target, random_angles<panda::arm>(random));
        most = std::max(most, found.steps);
        if (found.status != cca::reaching::unfinished) {
          reached += found.status == cca::reaching::reached;
          break;
        }
      }
    }
    CHECK(most <= 17);
    CHECK(reached >= 66);
  }

  TEST_CASE("a target that moves is searched as well, and is not out of reach before the search has ended") {
    using model = panda_pose;
    laws::source random{std::mt19937_64{35}};
    int reached = 0;
    for (int i = 0; i < 100; ++i) {
      const auto q = random_angles<panda::arm>(random, 0.9);
      typename model::vector by = random_angles<panda::arm>(random);
      by *= 1e-3 / by.norm();
      model::ik ik;
      for (int beat = 0; beat < 200; ++beat) {
        const auto found = one_beat(ik, model::at(q + beat % 100 * by));  // 1 rad/s at 1 kHz
        CHECK(found.status != cca::reaching::nearest);
        if (found.status == cca::reaching::reached) {
          ++reached;
          break;
        }
      }
    }
    CHECK(reached == 100);
  }

  TEST_CASE("a target that trembles out of reach stays out of reach") {
    using model = panda_position;
    laws::source random{std::mt19937_64{36}};
    model::ik ik;
    const Eigen::Vector3d target(1.5, 0.2, 0.3);
    int beats = 0;
    const auto settled = all_beats(ik, target, beats);
    REQUIRE(settled.status == cca::reaching::nearest);
    for (int i = 0; i < 100; ++i) {
      const auto found = one_beat(ik, (target + random.vector(1e-4)).eval());
      CHECK(found.status == cca::reaching::nearest);
      CHECK((found.q - settled.q).norm() < 0.01);
    }
    CHECK(one_beat(ik, Eigen::Vector3d(0.5, 0.2, 0.3)).status == cca::reaching::reached);
  }

  TEST_CASE("equal inputs give equal angles, and a copy goes on as the original") {
    laws::source random{std::mt19937_64{37}};
    panda_pose::ik one, two;
    for (int i = 0; i < 60; ++i) {
      auto target = panda_pose::at(random_angles<panda::arm>(random));
      if (i % 2 == 0) target.head<3>() *= 2;
      for (int beat = 0; beat < 5; ++beat) {
        auto copy = one;
        const auto a = one_beat(one, target), b = one_beat(two, target), c = one_beat(copy, target);
        CHECK(a.q == b.q);
        CHECK(a.q == c.q);
        CHECK(a.status == b.status);
      }
    }
    one.on_start();
    panda_pose::ik fresh;
    const auto target = panda_pose::at(random_angles<panda::arm>(random));
    CHECK(one_beat(one, target).q == one_beat(fresh, target).q);
  }
}
