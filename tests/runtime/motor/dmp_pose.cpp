// A pose on one phase: closed form of the orientation, changing goals, unit length.
#include <cca/motor/dmp_pose.hpp>

#include "rig.hpp"

using namespace motor_test;

namespace {

struct trunk : cca::frame<"trunk"> {};
struct hand : cca::frame<"hand"> {};
struct hand_in_trunk : cca::space<cca::pose<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};
using reach = cca::dmp_pose<hand_in_trunk, hand, 10>;
using vector7 = Eigen::Matrix<double, 7, 1>;
using cca::rotation::about;
using v3 = Eigen::Vector3d;
using v4 = Eigen::Vector4d;

vector7 pose(const v3& at, const v4& q) {
  vector7 v;
  v << at, q;
  return v;
}

struct pose_case {
  using ode = cca::dmp_pose_ode<6>;
  static constexpr double rate = 30;
  static ode::parameters parameters() {
    ode::parameters p{{}, 25, 5, 12, true};
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) p.weights(i, j) = 20 * std::sin(i + 2 * j);
    return p;
  }
  static vector7 random_pose(
      laws::ode_source& random) {  // less than a quarter turn, so the shorter way stays the same
    return pose(random.vector<v3>(-1, 1), cca::rotation::exp(random.vector<v3>(-0.4, 0.4)));
  }
  static ode::state state(laws::ode_source& random) {
    auto x = ode::at_rest(random_pose(random), random_pose(random));
    x.segment<3>(3) = random.vector<v3>(-1, 1), x.segment<3>(10) = random.vector<v3>(-1, 1);
    x[20] = random(0.05, 1);
    return x;
  }
  static ode::input input(laws::ode_source& random) {
    ode::input u;
    u << random_pose(random), random_pose(random), random(0.8, 2);
    return u;
  }
  static auto equilibrium(laws::ode_source& random) {
    const auto u = input(random);
    auto x = ode::at_rest(u.head<7>(), u.head<7>());
    x[20] = 0;
    return std::pair(x, u);
  }
};

auto step(reach& dmp, int k, const vector7& to, const vector7& from, bool again = false) {
  return dmp.process(
      given<cca::in<"goal", hand_in_trunk>>(to), wired<cca::optional_in<"start", hand_in_trunk>>(from), {},
      wired<cca::optional_in<"restart", cca::restart_signal>>(Eigen::Matrix<double, 1, 1>(0.0), again),
      at(k));
}

}  // namespace

TEST_CASE("the movement primitive of a pose obeys the laws of an ode") { laws::ode<pose_case>(); }

TEST_CASE("without weights the remaining angle falls like the distance, about a fixed axis, on one phase") {
  reach dmp;
  dmp.p.duration = 1.5;
  const v3 axis = v3(1, 2, -1).normalized();
  const v4 base = cca::rotation::from_roll_pitch_yaw(0.3, -0.2, 1.0);
  const v4 end = cca::rotation::product(about(axis, 1.2), base);
  for (int k = 0; k < 2500; ++k) {
    const auto [at_now, velocity, x, s] = step(dmp, k, pose({1, 0, 0}, end), pose({0, 0, 0}, base));
    const double l = 25 / (2 * 1.5), lt = l * 1e-3 * (k + 1), left = (1 + lt) * std::exp(-lt);
    const v4 q = at_now.vector().tail<4>();
    CHECK(std::abs(at_now.vector()[0] - (1 - left)) < 1e-9);
    CHECK((cca::rotation::log(cca::rotation::product(end, cca::rotation::inverse(q))) - 1.2 * left * axis)
              .norm() < 1e-8);
    CHECK((velocity.vector().head<3>() - 1.2 * l * lt * std::exp(-lt) * axis).norm() < 1e-7);
    CHECK(std::abs(velocity.vector()[3] - l * lt * std::exp(-lt)) < 1e-8);
    CHECK(std::abs(q.norm() - 1) < 1e-14);
  }
}

TEST_CASE("with the same weights position and rotation take the same course") {
  reach dmp;
  for (int j = 0; j < 10; ++j) dmp.p.weights.col(j).setConstant(50 * std::sin(j));
  const v3 way(0.3, -0.5, 0.2);
  double most = 0;
  for (int k = 0; k < 1500; ++k) {
    const auto at_now = std::get<0>(
        step(dmp, k, pose(way, cca::rotation::exp(v3(way[0], 0, 0))), pose({0, 0, 0}, {0, 0, 0, 1})));
    const v3 turned = cca::rotation::log(v4(at_now.vector().tail<4>()));
    CHECK(std::abs(turned[0] - at_now.vector()[0]) <
          1e-8);  // about one axis the rotation is a scalar, like the coordinate x
    most = std::max(most, std::abs(at_now.vector()[0] -
                                   0.3 * (1 - (1 + 0.0125 * (k + 1)) * std::exp(-0.0125 * (k + 1)))));
  }
  CHECK(most > 0.01);  // the weights have an effect
}

TEST_CASE(
    "a goal that changes during the movement is reached without a jump of the acceleration; a restart begins "
    "at the current pose") {
  reach dmp;
  const vector7 from = pose({0, 0, 0}, {0, 0, 0, 1}), first = pose({1, 0, 0}, about(v3(0, 0, 1), 1.5)),
                second = pose({0, 1, 0}, about(v3(0, 1, 0), -1.0));
  Eigen::Matrix<double, 6, 1> last = Eigen::Matrix<double, 6, 1>::Zero(), gained = last;
  double jump = 0, angle = 1, distance = 1, status = 0;
  for (int k = 0; k < 4000; ++k) {
    const auto [at_now, velocity, x, s] = step(dmp, k, k < 400 ? first : second, from);
    const Eigen::Matrix<double, 6, 1> gain = velocity.vector() - last;
    if (k > 200)
      jump = std::max(
          jump, (gain - gained).norm());  // of the acceleration; that of a spring jumps at the beginning
    gained = gain;
    last = velocity.vector();
    angle = cca::rotation::angle(
        cca::rotation::product(v4(second.tail<4>()), cca::rotation::inverse(v4(at_now.vector().tail<4>()))));
    distance = (at_now.vector() - second).head<3>().norm();
    status = s[cca::ode_axis{}];
  }
  CHECK(angle < 1e-6);
  CHECK(distance < 1e-6);
  CHECK(jump < 0.02);  // unfiltered: 0.45
  CHECK(status == cca::status_of(cca::ode_status::converged));
  const auto [at_now, velocity, x, s] = step(dmp, 0, first, from, true);
  CHECK((at_now.vector() - second).head<3>().norm() < 1e-3);
  CHECK(x.vector()[0] == doctest::Approx(std::exp(-5e-3)));
}

TEST_CASE(
    "after a restart it moves like a new one from there, and it normalises a quaternion that is not of unit "
    "length") {
  double length = 0;
  SUBCASE("longer") { length = 3; }
  SUBCASE("almost zero") { length = 1e-12; }
  reach used, fresh;
  for (int j = 0; j < 10; ++j)
    used.p.weights.col(j) = fresh.p.weights.col(j) = Eigen::Matrix<double, 6, 1>::Constant(40 * std::cos(j));
  const vector7 from = pose({0.1, 0, 0}, about(v3(1, 0, 0), 0.4)),
                first = pose({1, 0.2, 0}, about(v3(0, 0, 1), 0.8)),
                second = pose({0, 1, -0.3}, about(v3(0, 1, 0), -0.9));
  vector7 other = second;
  other.tail<4>() *= length;
  for (int k = 0; k < 8000; ++k) (void)step(used, k, first, from);
  for (int k = 0; k < 1500; ++k) {
    const auto a = std::get<0>(step(used, k, other, from, k == 0)).vector(),
               b = std::get<0>(step(fresh, k, second, first)).vector();
    CHECK((a - b).norm() < 1e-6);
  }
}

TEST_CASE("the movement primitive of a pose does not allocate") {
  reach dmp;
  const std::size_t before = laws::allocations();
  for (int k = 0; k < 300; ++k)
    (void)step(dmp, k, pose({1, 0, 0}, about(v3(0, 0, 1), 1.5)), pose({0, 0, 0}, {0, 0, 0, 1}));
  CHECK(laws::allocations() == before);
}
