// Edges of steps, and ridges where a slope turns down, under the middle of capsules and under boxes.
#include <Eigen/Dense>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include <cca/sim/compiled/lanes/lanes.hpp>
#include <cca/sim/robot/world/robot_world.hpp>

#include "robots.hpp"

using namespace compiled_test;

namespace {

sim::scene ground_of(const sim::terrain& t, double friction = 0.75) {
  sim::scene s;
  s.ground = t.with_friction(friction), s.contact.friction = friction;
  return s;
}
// The ground ends at x = 0: it goes on a metre lower.
sim::scene cliff(double friction = 0.75) { return ground_of(sim::terrain::steps(-1, 10, 1, 0), friction); }
sim::scene table_to_0() {
  sim::scene s;
  s.contact.friction = 0.75;
  s.add(sim::fixed_box{{8, 8, 0.2}, cca::at(-4, 0, -0.1)});
  return s;
}
template <class R, class Real = double>
auto put(const sim::scene& s, const cca::placement& where) {
  sim::compiled_world<R, Real> w(s);
  w.place({Real(0.0)}, {Real(0.0)}, where, {}, {});
  return w;
}

struct plank : sledge {  // 5 m along y
  static constexpr std::array shapes{robots::on_base(robots::box(0.3, 5, 0.1))};
};

using triple = sim::detail::triple<double>;

// The least depth over all directions between two angles.
template <std::size_t Spans>
double least_depth(const sim::detail::spanned_shape<double, Spans>& s,
                   const triple& place,
                   double from,
                   double to) {
  double least = 1e9;
  for (int i = 0; i <= 20000; ++i) {
    const double angle = from + (to - from) * i / 20000;
    least = std::min(least, s.depth(place, {std::cos(angle), 0, std::sin(angle)}));
  }
  return least;
}
double angle_of(const triple& n) { return std::atan2(n[2], n[0]); }
template <std::size_t Spans>
int judged(laws::source& random, const sim::scene& around) {
  const sim::detail::ground g = sim::detail::ground_of(around, {});
  int touching = 0;
  for (int i = 0; i < 1000; ++i) {
    sim::detail::spanned_shape<double, Spans> s;
    s.radius = Spans == 1 ? random(0.01, 0.05) : 0;
    const double height = std::max(0.0, around.ground->height(0.5));
    s.middle = {random(-0.15, 0.15), random(-1, 1), height + random(-0.1, 0.15)};
    const Eigen::Quaterniond turn(Eigen::Vector4d(random.vector(1).homogeneous()).normalized());
    for (std::size_t k = 0; k < Spans; ++k) {
      const Eigen::Vector3d axis = random(0.02, 0.1) * (turn * Eigen::Vector3d::Unit(static_cast<int>(k)));
      s.spans[k] = {axis[0], axis[1], axis[2]};
    }
    sim::detail::each_edge(g, s.middle[0], 1, [&](std::int64_t, const sim::detail::ground_edge& e) {
      const triple at{e.x, 0, e.z};
      sim::detail::edge_touch<double> found;
      for (const auto& t : sim::detail::touches_of_edges(g, s, 1))
        if (t.depth > found.depth) found = t;
      const double least = least_depth(s, at, angle_of(e.left), angle_of(e.right)),
                   of_all = least_depth(s, at, -half_turn, half_turn),
                   of_faces = std::min(s.depth(at, e.left), s.depth(at, e.right));
      // An end of a capsule is a sphere: it touches with its nearest point.
      double of_ends = -1;
      for (const double end : {-1.0, 1.0}) {
        const triple off = at - (s.middle + end * s.spans[0]);
        if (Spans == 1)
          of_ends = std::max(of_ends, s.radius - std::sqrt(sim::detail::dot_in_profile(off, off)));
      }
      if (!(found.depth > 0)) {
        CHECK((of_all < 1e-6 || least > of_faces - 1e-6 || std::abs(least - of_ends) < 1e-6));
        return;
      }
      CHECK(of_all > 0);
      ++touching;
      CHECK(found.depth == doctest::Approx(least).epsilon(1e-3));
      // What touches is on the shape's surface, and so deep behind the edge.
      const triple off = found.at - at;
      CHECK(sim::detail::dot_in_profile(off, found.normal) == doctest::Approx(-found.depth).epsilon(1e-9));
    });
  }
  return touching;
}

}  // namespace

TEST_SUITE("compiled world: edges of the ground") {
  TEST_CASE("the least depth over all directions decides, of random capsules and boxes") {
    laws::source random{};
    for (const auto& t : {sim::terrain::steps(-1, 10, 1, 0), sim::terrain::steps(1, 10, 1, 0),
                          sim::terrain::slope(-0.5, 0)}) {
      const int capsules = judged<1>(random, ground_of(t)), boxes = judged<3>(random, ground_of(t));
      MESSAGE(t.name(), ": ", capsules, " capsules and ", boxes, " boxes touch");
      CHECK(capsules > 10);
      CHECK(boxes > 20);
    }
    // Where a slope turns up nothing sticks out.
    CHECK(judged<3>(random, ground_of(sim::terrain::slope(0.5, 0))) == 0);
  }

  TEST_CASE_TEMPLATE("what lies across the edge of a step lies as on the edge of a table", R, crate, roller) {
    const double height = std::is_same_v<R, crate> ? 0.05 : 0.02;
    for (const double turned : {0.0, 0.5}) {
      const auto where = cca::at(-0.02, 0, height) * cca::turned_about(cca::along_z, turned);
      auto on_ground = put<R>(cliff(), where), on_table = put<R>(table_to_0(), where);
      run(on_ground, 1000), run(on_table, 1000);
      const double apart = (on_ground.frame(-1).where.at - on_table.frame(-1).where.at).norm();
      MESSAGE("turned by ", turned, ": ", apart, " m apart");
      CHECK(apart < 2e-4);
      CHECK(on_ground.frame(-1).where.at[2] == doctest::Approx(height - deep(2)).epsilon(0.02));
      CHECK(std::abs(on_ground.frame(-1).where.turn(2, 0)) < 0.01);
      CHECK(on_ground.contact(0).pressing == doctest::Approx(mass * gravity).epsilon(1e-3));
      auto beyond = put<R>(cliff(), cca::at(0.04, 0, height));
      run(beyond, 1000);
      CHECK(beyond.frame(-1).where.at[2] < -0.1);
    }
  }

  TEST_CASE_TEMPLATE("across a ridge the middle touches", R, crate, roller) {
    const double height = (std::is_same_v<R, crate> ? 0.05 : 0.02) - deep(std::is_same_v<R, crate> ? 2 : 1);
    const double ridge = 0.5;  // rad, each side
    // The first face is level, so the ground and the robot are turned until both sides fall.
    auto w = put<R>(ground_of(sim::terrain::slope(-ridge, 0)),
                    cca::turned_about(cca::along_y, ridge / 2) * cca::at(0, 0, height));
    const Eigen::Vector3d before = w.frame(-1).where.at;
    run(w, 30);
    CHECK(w.contact(0).contacts == (std::is_same_v<R, crate> ? 2 : 1));
    CHECK((w.frame(-1).where.at - before).norm() < 2e-3);
    CHECK(w.contact(0).pressing > 0.5 * mass * gravity);
  }

  TEST_CASE("a capsule that leans on the edge of a step is pushed away across itself") {
    const auto lean = cca::turned_about(cca::along_y, half_turn / 4);
    auto w = put<roller>(cliff(0), lean * cca::at(0, 0, 0.02 - 0.001));
    w.advance({});
    const auto v = w.frame(-1).velocity;
    CHECK(v[0] > 1e-3);
    CHECK(std::abs(v[0] - (v[2] + gravity * 1e-3)) < 1e-5);
  }

  TEST_CASE("a crate that falls on the edge of a step comes to rest where the engine has it") {
    const auto where = cca::at(-0.04, 0, 0.06);
    const sim::scene around = cliff();
    auto w = put<crate>(around, where);
    sim::robot_world e(sim::model_of<crate>(), around);
    sim::moving_frame base;
    base.where.at = Eigen::Vector3d(-0.04, 0, 0.06);
    const std::array<double, 1> rest{};
    e.place(rest, rest, base);
    const std::array<sim::joint_law, 1> limp{};
    for (int i = 0; i < 1500; ++i) w.advance({}), e.advance(limp);
    const double apart = (w.frame(-1).where.at - e.frame(-1).where.at).norm();
    MESSAGE(apart, " m apart");
    CHECK(apart < 1e-3);
    CHECK(w.frame(-1).where.at[2] > 0.04);
  }

  TEST_CASE("stairs under a capsule: two neighbours carry it") {
    const double rise = 0.05, run_of_step = 0.1, pitch = std::atan2(rise, run_of_step);
    const sim::scene stairs = ground_of(sim::terrain::steps(rise, run_of_step, 50, -1));
    // Edges at x = -1 + 0.1 n, as high as n rises.
    const auto along = cca::at(0, 0, 11 * rise) * cca::turned_about(cca::along_y, -pitch);
    auto w = put<roller>(stairs, along * cca::at(0, 0, 0.02 - deep(2)));
    run(w, 100);
    CHECK(w.contact(0).contacts >= 2);
    CHECK((w.frame(-1).where.at - Eigen::Vector3d(0, 0, 11 * rise)).norm() < 0.03);
  }

  TEST_CASE_TEMPLATE("the wall of a step stops what slides into it", R, crate, roller) {
    const double low = std::is_same_v<R, crate> ? 0.05 : 0.02, front = std::is_same_v<R, crate> ? 0.15 : 0.22;
    for (const double turned : {0.0, 0.5}) {
      const sim::scene around = ground_of(sim::terrain::steps(0.3, 10, 1, 0), 0.1);
      sim::compiled_world<R> w(around);
      sim::robot_world e(sim::model_of<R>(), around);
      const auto where = cca::at(-0.4, 0, low) * cca::turned_about(cca::along_z, turned);
      w.place({}, {}, where, {}, {1, 0, 0});
      sim::moving_frame base;
      base.where.at = Eigen::Vector3d(-0.4, 0, low);
      base.where.turn = Eigen::AngleAxisd(turned, Eigen::Vector3d::UnitZ()).toRotationMatrix();
      base.velocity = Eigen::Vector3d::UnitX();
      const std::array<double, 1> rest{};
      e.place(rest, rest, base);
      double highest = 0, pressing = 0, farthest = -1;
      for (int i = 0; i < 1500; ++i) {
        w.advance({}), e.advance(std::array<sim::joint_law, 1>{});
        highest = std::max(highest, w.frame(-1).where.at[2] - low);
        farthest = std::max(farthest, w.frame(-1).where.at[0]);
        pressing = std::max(pressing, w.contact(0).pressing);
      }
      MESSAGE("turned by ", turned, ": farthest ", farthest, " m, ", highest, " m up, apart from the engine ",
              (w.frame(-1).where.at - e.frame(-1).where.at).norm());
      CHECK(highest < 2e-3);
      CHECK(pressing > 2 * mass * gravity);
      if (turned == 0) CHECK(farthest == doctest::Approx(-front).epsilon(0.05));
      CHECK(farthest < -0.02);
      if (turned == 0) CHECK((w.frame(-1).where.at - e.frame(-1).where.at).norm() < 0.02);
    }
  }

  TEST_CASE("a ball in the corner before a step touches floor and wall, and rolls no farther") {
    sim::scene around = ground_of(sim::terrain::steps(0.3, 10, 1, 0));
    around.add(sim::ball{.radius = 0.05, .mass = 0.2, .position = {-0.3, 0, 0.05}, .velocity = {1, 0, 0}});
    sim::compiled_world<crate> w(around);
    w.place({}, {}, cca::at(-5, 0, 0.05), {}, {});
    double highest = 0, farthest = -1;
    for (int i = 0; i < 800; ++i) {
      w.advance({});
      highest = std::max(highest, w.ball_position(0)[2]),
      farthest = std::max(farthest, w.ball_position(0)[0]);
    }
    CHECK(farthest == doctest::Approx(-0.05).epsilon(0.06));
    CHECK(highest < 0.07);  // its spin climbs the wall a little
  }

  TEST_CASE("what has come into the wall of a step goes back through it, what is in the top goes up") {
    using sim::detail::touch_of, sim::detail::touch_of_wall;
    for (const double rise : {0.3, -0.3}) {
      const auto g = sim::detail::ground_of(ground_of(sim::terrain::steps(rise, 1, 3, 0)), {});
      const double out = rise > 0 ? -1 : 1, high = std::max(rise, 0.0);  // of the first wall, at x = 0
      for (const double radius : {0.0, 0.05}) {
        const triple behind{-0.02 * out, 0, high - 0.1}, top{-0.02 * out, 0, high - 0.001},
            before{(radius / 2 + 0.001) * out, 0, high - 0.1}, inside{-0.4 * out, 0, high - 0.1};
        const auto wall = touch_of_wall(g, behind, radius);
        CHECK(wall.depth == doctest::Approx(radius + 0.02));
        CHECK(wall.normal[0] == out);
        CHECK(touch_of(g, behind, radius).depth < 0);
        CHECK(touch_of_wall(g, top, radius).depth < 0);
        CHECK(touch_of(g, top, radius).depth == doctest::Approx(radius + 0.001));
        CHECK(touch_of_wall(g, before, radius).depth == doctest::Approx(radius / 2 - 0.001));
        CHECK(touch_of_wall(g, inside, radius).depth < 0);
        CHECK(touch_of(g, inside, radius).depth == doctest::Approx(radius + 0.1));
        // Above the edge and below the floor there is no wall; nor on a slope.
        CHECK(touch_of_wall(g, triple{0.01 * out, 0, high + 0.01}, radius).depth < 0);
        CHECK(touch_of_wall(g, triple{0.01 * out, 0, high - 0.31}, radius).depth < 0.1);
      }
    }
    const auto slope = sim::detail::ground_of(ground_of(sim::terrain::slope(-0.5, 0)), {});
    CHECK(touch_of_wall(slope, triple{0.01, 0, -0.1}, 0.05).depth < 0);
  }

  TEST_CASE("the engine's ground reaches as far as what lies on it") {
    sim::robot_world e(sim::model_of<plank>(), ground_of(sim::terrain::steps(-0.05, 10, 1, 3)));
    sim::moving_frame base;
    base.where.turn = Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitX()).toRotationMatrix();
    base.where.at = Eigen::Vector3d(0, 0, 2.5 * std::sin(0.6) + 0.06);
    const std::array<double, 1> rest{};
    e.place(rest, rest, base);
    double lowest = 0;
    for (int i = 0; i < 600; ++i) {
      e.advance(std::array<sim::joint_law, 1>{});
      for (const double end : {-2.5, 2.5}) {
        const auto& where = e.frame(-1).where;
        lowest = std::min(lowest, (where.at + where.turn * Eigen::Vector3d(0, end, -0.05))[2]);
      }
    }
    CHECK(lowest > -0.02);
  }

  TEST_CASE_TEMPLATE("each lane has the bits of a world alone", R, crate, roller) {
    using both = sim::lanes<2>;
    const sim::scene around = ground_of(sim::terrain::steps(-0.05, 0.15, 20, 0));
    sim::compiled_world<R, both> all(around);
    const std::array<double, 2> tilt{0.3, -0.4};
    std::vector<sim::compiled_world<R>> alone;
    const auto where = [&](double t) {
      return cca::at(0.02, 0, 0.09) * cca::turned_about(cca::along_y, t) *
             cca::turned_about(cca::along_z, t / 3);
    };
    for (const double t : tilt) alone.push_back(put<R>(around, where(t)));
    // The lanes begin as the first one, and a turn of the base is each lane's own.
    all.place({both(0.0)}, {both(0.0)}, where(tilt[0]), {}, {});
    auto other = all.save();
    const auto second = alone[1].save().motion;
    for (std::size_t k = 0; k < 4; ++k) other.motion.attitude.q[k].set(1, second.attitude.q[k]);
    all.restore(other);
    int differs = 0, touches = 0;
    for (int i = 0; i < 600; ++i) {
      all.advance({});
      for (std::size_t l = 0; l < 2; ++l) {
        alone[l].advance({});
        const auto& one = alone[l].save().motion;
        const auto& of = all.save().motion;
        for (std::size_t k = 0; k < 3; ++k) {
          differs += one.at[k] != of.at[k][static_cast<int>(l)];
          differs += one.velocity[k] != of.velocity[k][static_cast<int>(l)];
        }
        touches += alone[l].contact(0).contacts > 0;
      }
    }
    CHECK(differs == 0);
    CHECK(touches > 200);
  }
}
