// The methods of each domain type, by examples with known results.
#include "spaces.hpp"

#include <Eigen/Geometry>

using namespace spaces;
using doctest::Approx;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr cca::y y;

bool near(const auto& a, const auto& b) { return (a - b).norm() < 1e-12; }

}  // namespace

TEST_SUITE("space methods") {
  TEST_CASE("angles wrap into half-open turns, and an angle inside keeps every bit") {
    const double tiny = 1e-300, below = std::nextafter(cca::pi, 0), above = std::nextafter(cca::pi, 4);
    CHECK(cca::wrap_signed(cca::pi) == cca::pi);
    CHECK(cca::wrap_signed(-cca::pi) == cca::pi);
    CHECK(cca::wrap_signed(std::nextafter(-cca::pi, 0)) == -below);
    CHECK(cca::wrap_signed(above) > -cca::pi);
    CHECK(cca::wrap_signed(above) < -3);
    CHECK(cca::wrap_signed(3 * cca::pi) == Approx(cca::pi));
    CHECK(cca::wrap_signed(-tiny) == -tiny);
    CHECK(cca::wrap_turn(2 * cca::pi) == 0);
    CHECK(cca::wrap_turn(-tiny) == 0);
    CHECK(cca::wrap_turn(-1) == Approx(2 * cca::pi - 1));
    CHECK(std::isnan(cca::wrap_signed(not_a_number)));
    CHECK(std::isnan(cca::wrap_turn(infinite)));
    laws::source random{std::mt19937_64{8}};
    for (int i = 0; i < 20000; ++i) {
      const double turns = std::round(random(-50, 50)),
                   angle = turns * cca::pi + random(-1, 1) * std::pow(10, random(-17, 0));
      const double s = cca::wrap_signed(angle), t = cca::wrap_turn(angle);
      REQUIRE((s > -cca::pi && s <= cca::pi));
      REQUIRE((t >= 0 && t < 2 * cca::pi));
      REQUIRE(cca::wrap_signed(s) == s);
      REQUIRE(cca::wrap_turn(t) == t);
    }
  }

  TEST_CASE("joint angles") {
    using sample = cca::sample<leg_angles>;
    const sample q(Eigen::Vector2d(0.5, -1), 7);
    CHECK(q[hip{}] == 0.5);
    CHECK(q[knee{}] == -1);
    CHECK(q.on<knee>()[knee{}] == -1);
    CHECK(q.on<knee>().origin() == 7);
    CHECK(q.within_limits());
    const sample far(Eigen::Vector2d(4, -4), 7);
    CHECK_FALSE(far.within_limits());
    CHECK_FALSE(sample(Eigen::Vector2d(0, -1.9)).within_limits());
    CHECK_FALSE(sample(Eigen::Vector2d(0, 0.1)).within_limits());
    CHECK(far.clamped().vector() == Eigen::Vector2d(0.9, -1.8));
    CHECK(far.clamped().origin() == 7);
    CHECK(far.clamped().within_limits());
    CHECK(near(far.normalised().vector(), Eigen::Vector2d(4 - 2 * cca::pi, 2 * cca::pi - 4)));
    CHECK_FALSE(sample(Eigen::Vector2d(not_a_number, -1)).within_limits());
    CHECK(std::isnan(sample(Eigen::Vector2d(not_a_number, -1)).clamped()[hip{}]));
    CHECK(near(sample(Eigen::Vector2d(3, 0)).difference(sample(Eigen::Vector2d(-3, 0))),
               Eigen::Vector2d(6 - 2 * cca::pi, 0)));
    CHECK(near(sample(Eigen::Vector2d(3, 0)).interpolated(sample(Eigen::Vector2d(-3, 0)), 0.5).vector(),
               Eigen::Vector2d(0, 0)));
  }

  TEST_CASE("an axis without limits for a quantity has none") {
    using sample = cca::sample<leg_velocities>;
    CHECK(sample(Eigen::Vector2d(6, 1e9)).within_limits());
    CHECK_FALSE(sample(Eigen::Vector2d(6.1, 0)).within_limits());
    CHECK(sample(Eigen::Vector2d(-7, 1e9)).clamped().vector() == Eigen::Vector2d(-6, 1e9));
  }

  TEST_CASE("velocities, torques and springs") {
    const cca::sample<leg_velocities> v(Eigen::Vector2d(2, -3));
    CHECK(v.displacement(0.1).isApprox(Eigen::Vector2d(0.2, -0.3)));
    CHECK(cca::sample<leg_angles>().plus(v.displacement(0.1)).vector().isApprox(Eigen::Vector2d(0.2, -0.3)));
    CHECK(cca::sample<leg_torques>(Eigen::Vector2d(5, 7)).power(v) == Approx(10 - 21));
    CHECK(cca::sample<leg_stiffness>(Eigen::Vector2d(5, 7))
              .torque(Eigen::Vector2d(0.1, -0.2))
              .isApprox(Eigen::Vector2d(-0.5, 1.4)));
    CHECK(cca::sample<leg_damping>(Eigen::Vector2d(5, 7)).torque(v).isApprox(Eigen::Vector2d(-10, 21)));
    CHECK(cca::sample<leg_torques>(cca::sample<leg_damping>(Eigen::Vector2d(5, 7)).torque(v)).power(v) ==
          Approx(-20 - 63));
  }

  TEST_CASE("positions") {
    const cca::sample<foot> a(Eigen::Vector3d(1, 2, 3)), b(Eigen::Vector3d(1, 5, 7));
    CHECK(a.distance(b) == 5);
    CHECK(b.difference(a) == Eigen::Vector3d(0, 3, 4));
    CHECK(a.plus(Eigen::Vector3d(0, 3, 4)).vector() == b.vector());
    CHECK(a.interpolated(b, 0.5).vector() == Eigen::Vector3d(1, 3.5, 5));
    CHECK(a[y] == 2);
  }

  TEST_CASE("phases") {
    using sample = cca::sample<phases>;
    const sample p(Eigen::Vector2d(-0.1, 7));
    CHECK(near(p.wrapped().vector(), Eigen::Vector2d(2 * cca::pi - 0.1, 7 - 2 * cca::pi)));
    CHECK(near(p.advanced(0.2).vector(), Eigen::Vector2d(0.1, 7.2 - 2 * cca::pi)));
    const sample late(Eigen::Vector2d(6.2, 6.2)), early(Eigen::Vector2d(0.1, 0.1));
    CHECK(early.difference(late)[0] == Approx(0.1 - 6.2 + 2 * cca::pi));
    CHECK(late.difference(early)[0] < 0);
    CHECK(late.interpolated(early, 0.5)[hip{}] == Approx(3.15 - cca::pi));
    CHECK(sample(Eigen::Vector2d(0, cca::pi)).interpolated(sample(Eigen::Vector2d(cca::pi, 0)), 0.5)[hip{}] ==
          Approx(cca::pi / 2));
    CHECK(sample(Eigen::Vector2d(6.2, 0.1)).mean() == Approx(3.15 - cca::pi));
    CHECK(sample(Eigen::Vector2d(1, 1)).coherence() == Approx(1));
    CHECK(sample(Eigen::Vector2d(1, 1 + cca::pi)).coherence() == Approx(0));
  }

  enum class mode : std::uint8_t { stance, swing, fallen };
  enum class error { none, hot = -3 };

  TEST_CASE("status") {
    const cca::sample<modes> s(Eigen::Vector2d(cca::status_of(mode::swing), cca::status_of(error::hot)));
    CHECK(s.as<mode>(hip{}) == mode::swing);
    CHECK(s.as<error>(knee{}) == error::hot);
    const cca::sample<modes> wild(Eigen::Vector2d(not_a_number, 1e300));
    CHECK(wild.as<mode>(hip{}) == mode::stance);
    CHECK(wild.as<mode>(knee{}) == mode::stance);
    CHECK(cca::sample<modes>(Eigen::Vector2d(-1, 0)).as<mode>(hip{}) == mode::stance);
    CHECK(cca::sample<modes>(Eigen::Vector2d(256, 0)).as<mode>(hip{}) == mode::stance);
    CHECK(s.on<hip>().as<mode>() == mode::swing);
    CHECK(s.on<hip>().is(mode::swing));
    CHECK_FALSE(s.on<hip>().is(mode::fallen));
  }

  TEST_CASE("frequencies") {
    CHECK(cca::sample<frequencies>(Eigen::Vector2d(1, 2))
              .angular_frequency()
              .isApprox(2 * cca::pi * Eigen::Vector2d(1, 2)));
  }

  TEST_CASE("orientations agree with Eigen's quaternions") {
    using sample = cca::sample<attitude>;
    laws::source random{std::mt19937_64{9}};
    for (int i = 0; i < 200; ++i) {
      const auto a = orientation_model::random(random), b = orientation_model::random(random);
      const Eigen::Quaterniond p(a.vector()), q(b.vector());
      const Eigen::Vector3d v = random.vector(2);
      const double t = random(0, 1);
      CHECK(near((a * b).vector(), (p * q).coeffs()));
      CHECK(near(a.rotate(v), p * v));
      CHECK(near(a.matrix(), p.toRotationMatrix()));
      CHECK(a.angle_to(b) == Approx(p.angularDistance(q)).epsilon(1e-9));
      CHECK(sample::from(p.slerp(t, q)).angle_to(a.interpolated(b, t)) < 1e-9);
      CHECK(near(sample::from(p).vector(), a.vector()));
      const Eigen::AngleAxisd turn(t, v.normalized());
      CHECK(near(sample::from(turn).vector(), Eigen::Quaterniond(turn).coeffs()));
      CHECK(near(sample::about(v, t).vector(), Eigen::Quaterniond(turn).coeffs()));
      CHECK(near(sample::from_rotation_vector(v).rotation_vector(),
                 Eigen::Vector3d(v.norm() <= cca::pi ? v : v * (1 - 2 * cca::pi / v.norm()))));
    }
  }

  TEST_CASE("roll, pitch and yaw, and back") {
    using sample = cca::sample<attitude>;
    laws::source random{std::mt19937_64{10}};
    for (int i = 0; i < 200; ++i) {
      const double roll = random(-3.1, 3.1), pitch = random(-1.5, 1.5), yaw = random(-3.1, 3.1);
      const auto o = sample::from_roll_pitch_yaw(roll, pitch, yaw);
      CHECK(o.roll() == Approx(roll).epsilon(1e-9));
      CHECK(o.pitch() == Approx(pitch).epsilon(1e-9));
      CHECK(o.yaw() == Approx(yaw).epsilon(1e-9));
      using axis = Eigen::AngleAxisd;
      const Eigen::Vector3d ex(1, 0, 0), ey(0, 1, 0), ez(0, 0, 1);
      CHECK(near(o.vector(), (axis(yaw, ez) * axis(pitch, ey) * axis(roll, ex)).coeffs()));
    }
    const double up = 0.70710678118654768;  // rounding makes 2 * up * up > 1
    CHECK(sample(Eigen::Vector4d(0, up, 0, up)).pitch() == cca::pi / 2);
    CHECK(sample(Eigen::Vector4d(0, -up, 0, up)).pitch() == -cca::pi / 2);
  }

  TEST_CASE("orientations: q and -q are one rotation, and small rotations") {
    using sample = cca::sample<attitude>;
    const sample a(Eigen::Vector4d(0.5, -0.5, 0.5, -0.5)), b(Eigen::Vector4d(-0.5, 0.5, -0.5, 0.5));
    CHECK(a == b);
    CHECK(a.canonical().vector() == b.vector());
    CHECK(sample(Eigen::Vector4d(-1, 0, 0, 0)).canonical().vector() == Eigen::Vector4d(1, 0, 0, 0));
    CHECK_FALSE(a == sample());
    CHECK(sample().vector() == Eigen::Vector4d(0, 0, 0, 1));
    CHECK(sample(Eigen::Vector4d(0, 0, 2, 0)).normalised().vector() == Eigen::Vector4d(0, 0, 1, 0));
    CHECK(sample(Eigen::Vector4d(0, 0, 0, 0)).normalised() == sample());
    for (const double size : {0.0, 1e-200, 1e-12, 1e-8, 3.3e-5, 3.4e-5, 1e-3}) {
      const Eigen::Vector3d v(size, -2 * size, 2 * size);
      CHECK((sample::from_rotation_vector(v).rotation_vector() - v).norm() <= 1e-14 * size);
      CHECK(sample::from_rotation_vector(v)
                .interpolated(sample(), 0.25)
                .rotation_vector()
                .isApprox(0.75 * v, 1e-6));
    }
  }

  TEST_CASE("poses") {
    using sample = cca::sample<foot_pose>;
    const auto quarter = cca::sample<attitude>::about({0, 0, 1}, cca::pi / 2);
    const auto p = sample::of(cca::sample<foot>(Eigen::Vector3d(1, 2, 3), 4), quarter);
    CHECK(p.origin() == 4);
    CHECK(near(p.transform(Eigen::Vector3d(1, 0, 0)), Eigen::Vector3d(1, 3, 3)));
    CHECK(near(p.express(cca::sample<foot_in_trunk>(Eigen::Vector3d(1, 0, 0))).vector(),
               Eigen::Vector3d(1, 3, 3)));
    static_assert(std::is_same_v<decltype(p.express(cca::sample<foot_in_trunk>()))::space::domain,
                                 cca::cartesian_position<world>>);
    CHECK(p.position().vector() == Eigen::Vector3d(1, 2, 3));
    const bool same = p.orientation() == quarter;  // two matching spaces with different names
    CHECK(same);
    CHECK(p.interpolated(sample(), 0.5).position().vector() == Eigen::Vector3d(0.5, 1, 1.5));
    CHECK(p.interpolated(sample(), 0.5).orientation().yaw() == Approx(cca::pi / 4));
    CHECK(sample().vector().tail<4>() == Eigen::Vector4d(0, 0, 0, 1));
  }

  // A wheel of radius 1 rolls along x: its centre moves, the point on the ground is at rest.
  TEST_CASE("twists: another point, and another frame") {
    struct centre;
    struct contact;
    struct wheel : cca::space<cca::twist<centre, world>, xyz> {};
    cca::sample<wheel> rolling((Eigen::Matrix<double, 6, 1>() << 0, 2, 0, 2, 0, 0).finished(), 9);
    const auto down = rolling.moved_to<contact>(Eigen::Vector3d(0, 0, -1));
    CHECK(down.linear() == Eigen::Vector3d(0, 0, 0));
    CHECK(down.angular() == Eigen::Vector3d(0, 2, 0));
    CHECK(down.origin() == 9);
    static_assert(std::is_same_v<decltype(down)::space::domain, cca::twist<contact, world>>);
    const auto turned = cca::sample<attitude_in_trunk>::about({0, 0, 1}, cca::pi / 2).express(rolling);
    static_assert(std::is_same_v<decltype(turned)::space::domain, cca::twist<centre, trunk>>);
    CHECK(near(turned.angular(), Eigen::Vector3d(-2, 0, 0)));
    CHECK(near(turned.linear(), Eigen::Vector3d(0, 2, 0)));
  }

  // A force of 10 N on a lever of 1 m is a torque of 10 N m, by the right-hand rule.
  TEST_CASE("wrenches") {
    using six = Eigen::Matrix<double, 6, 1>;
    struct here;
    struct there;
    struct push : cca::space<cca::wrench<there, world>, xyz> {};
    const cca::sample<push> up((six() << 0, 0, 0, 0, 0, 10).finished());
    // `there` is at +y of `here`, so the lever from there to here is -y.
    const auto about = up.moved_to<here>(cca::sample<foot>(Eigen::Vector3d(0, -1, 0)));
    CHECK(about.torque() == Eigen::Vector3d(10, 0, 0));
    CHECK(about.force() == Eigen::Vector3d(0, 0, 10));
  }

  TEST_CASE("forces") {
    const cca::sample<push> f(Eigen::Vector3d(3, 0, 4), 7);
    CHECK(f.magnitude() == 5);
    CHECK((f + f).vector() == Eigen::Vector3d(6, 0, 8));
    // A quarter turn about z: what points along x of the world points along y of the trunk.
    const auto turned = cca::sample<attitude_in_trunk>::about({0, 0, 1}, cca::pi / 2).express(f);
    CHECK(std::is_same_v<decltype(turned)::space::domain, cca::cartesian_force<trunk>>);
    CHECK(near(turned.vector(), Eigen::Vector3d(0, 3, 4)));
    CHECK(turned.origin() == 7);
  }

  TEST_CASE("Cartesian stiffness and damping") {
    using six = Eigen::Matrix<double, 6, 1>;
    const six diagonal = (six() << 1, 2, 3, 40, 50, 60).finished(),
              moved = (six() << 0.1, 0, -0.1, 0.01, 0.02, -0.03).finished();
    const cca::sample<springs> k(diagonal, 5);
    CHECK(k.rotational() == Eigen::Vector3d(1, 2, 3));
    CHECK(k.linear() == Eigen::Vector3d(40, 50, 60));
    const auto back = k.wrench(moved);
    CHECK(std::is_same_v<decltype(back)::space::domain, cca::wrench<trunk, world>>);
    CHECK(near(back.torque(), Eigen::Vector3d(-0.1, 0, 0.3)));
    CHECK(near(back.force(), Eigen::Vector3d(-0.4, -1, 1.8)));
    CHECK(back.origin() == 5);
    const cca::sample<motion> v(moved, 3);
    const auto against = cca::sample<dampers>(diagonal, 5).wrench(v);
    CHECK(against.vector() == back.vector());
    CHECK(against.origin() == 3);
    CHECK(against.power(v) == Approx(-moved.dot(diagonal.cwiseProduct(moved))));
  }

  TEST_CASE("power is the same at any point and along any axes") {
    struct elsewhere;
    laws::source random{std::mt19937_64{11}};
    for (int i = 0; i < 200; ++i) {
      const auto t = plain_model<motion>::random(random);
      const auto w = plain_model<load>::random(random);
      const Eigen::Vector3d lever = random.vector(2);
      const auto o = cca::sample<attitude_in_trunk>::from_rotation_vector(random.vector(2));
      const double power = w.power(t);
      CHECK(power == Approx(w.force().dot(t.linear()) + w.torque().dot(t.angular())).epsilon(1e-12));
      CHECK(w.moved_to<elsewhere>(lever).power(t.moved_to<elsewhere>(lever)) == Approx(power).epsilon(1e-9));
      CHECK(o.express(w).power(o.express(t)) == Approx(power).epsilon(1e-9));
    }
  }

  TEST_CASE("a sample converts to a matching space of another name") {
    struct same : cca::space<cca::joint_angles, leg> {};
    const cca::sample<leg_angles> q(Eigen::Vector2d(1, 2), 3);
    const cca::sample<same> other = q;
    CHECK(other.vector() == q.vector());
    CHECK(other.origin() == 3);
    struct long_numbers : cca::space<cca::number, leg> {};
    CHECK(cca::sample<long_numbers>().origin() == cca::never);
  }
}
