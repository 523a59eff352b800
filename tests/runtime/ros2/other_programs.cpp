// Messages go both ways between a controller and programs that share no code with cca: one on code that
// Cyclone's idlc generates, one on Fast DDS.
#include <doctest/doctest.h>

#include <string>
#include <tuple>

#include "peer.hpp"
#include "spaces.hpp"

using namespace ros2_test;

namespace {

struct source {
  auto process() -> std::tuple<cca::out<"angles", leg_angles>,
                               cca::out<"velocities", leg_velocities>,
                               cca::out<"torques", leg_torques>,
                               cca::out<"attitude", attitude>,
                               cca::out<"turning", turning>,
                               cca::out<"accelerated", accelerated>,
                               cca::out<"load", load>,
                               cca::out<"motion", motion>,
                               cca::out<"numbers", numbers>> {
    using Eigen::Vector2d, Eigen::Vector3d;
    Eigen::Matrix<double, 6, 1> six;
    six << 4, 5, 6, 1, 2, 3;  // the angular part is first here, and second in ROS 2
    return {Vector2d(0.25, -0.5),
            Vector2d(1, 2),
            Vector2d(3, 4),
            Eigen::Vector4d(0, 0, 0.6, 0.8),
            Vector3d(1, 2, 3),
            Vector3d(4, 5, 9.81),
            six,
            six,
            Vector2d(7, 8)};
  }
};
struct other_source {
  auto process() -> std::tuple<cca::out<"place", place>,
                               cca::out<"times", cca::ros2::trajectory_times<points>>,
                               cca::out<"way", way>,
                               cca::out<"way_velocities", way_velocities>,
                               cca::out<"picture", picture>> {
    return {where(), Eigen::Vector3d(0.5, 1.25, 1.25), angles(), velocities(), colour()};
  }
  static numbers_of<places> where() {
    numbers_of<places> p;
    p << 1, 2, 3, 0, 0, 0.6, 0.8;
    return p;
  }
  // Two points: the last time does not rise.
  static Eigen::Matrix<double, 6, 1> angles() {
    Eigen::Matrix<double, 6, 1> all;
    all << 0.25, -0.5, 0.5, -1, 0.5, -1;
    return all;
  }
  static Eigen::Matrix<double, 6, 1> velocities() {
    Eigen::Matrix<double, 6, 1> all;
    all << 1, 2, 3, 4, 3, 4;
    return all;
  }
  static numbers_of<pictures> colour() { return numbers_of<pictures>::LinSpaced(10, 240); }
};

struct talker : cca::graph<cca::rate<100>,
                           cca::node<"robot", source>,
                           cca::node<"other", other_source>,
                           cca::node<"states", cca::ros2::publisher<"cca/joint_state", joints>>,
                           cca::node<"imu", cca::ros2::publisher<"cca/imu", inertial>>,
                           cca::node<"load", cca::ros2::publisher<"cca/wrench", loads>>,
                           cca::node<"motion", cca::ros2::publisher<"cca/twist", motions>>,
                           cca::node<"numbers", cca::ros2::publisher<"cca/array", array>>,
                           cca::node<"place", cca::ros2::publisher<"cca/pose", places>>,
                           cca::node<"command", cca::ros2::publisher<"cca/command", commands>>,
                           cca::node<"transform", cca::ros2::publisher<"cca/transform", transforms>>,
                           cca::node<"tree", cca::ros2::publisher<"cca/tf", tree>>,
                           cca::node<"way", cca::ros2::publisher<"cca/way", ways>>,
                           cca::node<"picture", cca::ros2::publisher<"cca/image", pictures>>,
                           cca::wire<"robot.angles", "states.position">,
                           cca::wire<"robot.velocities", "states.velocity">,
                           cca::wire<"robot.torques", "states.effort">,
                           cca::wire<"robot.attitude", "imu.orientation">,
                           cca::wire<"robot.turning", "imu.angular_velocity">,
                           cca::wire<"robot.accelerated", "imu.linear_acceleration">,
                           cca::wire<"robot.load", "load.wrench">,
                           cca::wire<"robot.motion", "motion.twist">,
                           cca::wire<"robot.numbers", "numbers.data">,
                           cca::wire<"other.place", "place.pose">,
                           cca::wire<"robot.motion", "command.twist">,
                           cca::wire<"other.place", "transform.transform">,
                           cca::wire<"other.place", "tree.transform">,
                           cca::wire<"other.times", "way.times">,
                           cca::wire<"other.way", "way.positions">,
                           cca::wire<"other.way_velocities", "way.velocities">,
                           cca::wire<"other.picture", "picture.image">> {};

struct recorder {
  numbers_of<joints> joint_state = numbers_of<joints>::Zero();
  numbers_of<inertial> imu = numbers_of<inertial>::Zero();
  numbers_of<loads> wrench = numbers_of<loads>::Zero();
  numbers_of<motions> twist = numbers_of<motions>::Zero();
  numbers_of<array> data = numbers_of<array>::Zero();

  void process(const cca::in<"angles", leg_angles>& q,
               const cca::in<"velocities", leg_velocities>& v,
               const cca::in<"torques", leg_torques>& t,
               const cca::in<"attitude", attitude>& a,
               const cca::in<"turning", turning>& w,
               const cca::in<"accelerated", accelerated>& f,
               const cca::in<"load", load>& l,
               const cca::in<"motion", motion>& m,
               const cca::in<"numbers", numbers>& n) {
    joint_state << q.vector(), v.vector(), t.vector();
    imu << a.vector(), w.vector(), f.vector();
    wrench = l.vector();
    twist = m.vector();
    data = n.vector();
  }
};
struct other_recorder {
  numbers_of<places> pose = numbers_of<places>::Zero(), transform = pose, tree = pose;
  numbers_of<commands> command = numbers_of<commands>::Zero();
  numbers_of<ways> trajectory = numbers_of<ways>::Zero();
  numbers_of<pictures> image = numbers_of<pictures>::Zero();

  void process(const cca::in<"pose", place>& p,
               const cca::in<"transform", place>& t,
               const cca::in<"tree", place>& f,
               const cca::in<"command", motion>& c,
               const cca::in<"times", cca::ros2::trajectory_times<points>>& s,
               const cca::in<"way", way>& w,
               const cca::in<"way_velocities", way_velocities>& v,
               const cca::in<"picture", picture>& i) {
    pose = p.vector();
    transform = t.vector();
    tree = f.vector();
    command = c.vector();
    trajectory << s.vector(), w.vector(), v.vector();
    image = i.vector();
  }
};

struct listener : cca::graph<cca::rate<100>,
                             cca::node<"joints", cca::ros2::subscriber<"cca/joint_state", joints>>,
                             cca::node<"imu", cca::ros2::subscriber<"cca/imu", inertial>>,
                             cca::node<"load", cca::ros2::subscriber<"cca/wrench", loads>>,
                             cca::node<"motion", cca::ros2::subscriber<"cca/twist", motions>>,
                             cca::node<"numbers", cca::ros2::subscriber<"cca/array", array>>,
                             cca::node<"place", cca::ros2::subscriber<"cca/pose", places>>,
                             cca::node<"command", cca::ros2::subscriber<"cca/command", commands>>,
                             cca::node<"transform", cca::ros2::subscriber<"cca/transform", transforms>>,
                             cca::node<"tree", cca::ros2::subscriber<"cca/tf", tree>>,
                             cca::node<"way", cca::ros2::subscriber<"cca/way", ways>>,
                             cca::node<"picture", cca::ros2::subscriber<"cca/image", pictures>>,
                             cca::node<"here", recorder>,
                             cca::node<"others", other_recorder>,
                             cca::wire<"joints.position", "here.angles">,
                             cca::wire<"joints.velocity", "here.velocities">,
                             cca::wire<"joints.effort", "here.torques">,
                             cca::wire<"imu.orientation", "here.attitude">,
                             cca::wire<"imu.angular_velocity", "here.turning">,
                             cca::wire<"imu.linear_acceleration", "here.accelerated">,
                             cca::wire<"load.wrench", "here.load">,
                             cca::wire<"motion.twist", "here.motion">,
                             cca::wire<"numbers.data", "here.numbers">,
                             cca::wire<"place.pose", "others.pose">,
                             cca::wire<"transform.transform", "others.transform">,
                             cca::wire<"tree.transform", "others.tree">,
                             cca::wire<"command.twist", "others.command">,
                             cca::wire<"way.times", "others.times">,
                             cca::wire<"way.positions", "others.way">,
                             cca::wire<"way.velocities", "others.way_velocities">,
                             cca::wire<"picture.image", "others.picture">> {};

// What a peer prints of the first message that it hears from the controller.
std::string heard_by(const char* program,
                     cca::controller<talker>& c,
                     const std::string& type,
                     const std::string& topic) {
  peer other(program, "hear", type, topic);
  int beat = 0;
  within_seconds(30, [&] {
    if (++beat % 10 == 0) c.step();
    return other.has_said();
  });
  return other.said;
}

void all_are_heard_by(const char* program, bool prints_user_data) {
  use_own_domain();
  cca::controller<talker> c;
  c.load();
  c.start();
  const auto expect = [&](const char* type, const char* topic, std::string text, const char* hash) {
    const auto bar = text.find(" |");
    if (prints_user_data) text.insert(bar, std::string(" typehash=RIHS01_") + hash + ";");
    CHECK_EQ(heard_by(program, c, type, topic), text + "\n");
  };
  expect("JointState", "cca/joint_state", "frame ``, stamped now hip knee | 0.25 -0.5 | 1 2 | 3 4",
         "a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e");
  expect("Imu", "cca/imu",
         "frame `trunk`, stamped now | 0 0 0.6 0.8 | 0 0 0 0 0 0 0 0 0 | 1 2 3 | 0 0 0 0 0 0 0 0 0 "
         "| 4 5 9.81 | 0 0 0 0 0 0 0 0 0",
         "7d9a00ff131080897a5ec7e26e315954b8eae3353c3f995c55faf71574000b5b");
  expect("WrenchStamped", "cca/wrench", "frame `trunk`, stamped now | 1 2 3 | 4 5 6",
         "8dc3deaf06b2ab281f9f9a742a8961c328ca7cec16e3fd6586d3a5c83fa78f77");
  expect("TwistStamped", "cca/twist", "frame `world`, stamped now | 1 2 3 | 4 5 6",
         "5f0fcd4f81d5d06ad9b4c4c63e3ea51b82d6ae4d0558f1d475229b1121db6f64");
  expect("Float64MultiArray", "cca/array", "frame ``, no stamp hip,knee | 0 | 2 2 | 7 8",
         "1025ddc6b9552d191f89ef1a8d2f60f3d373e28b283d8891ddcc974e8c55397f");
  expect("PoseStamped", "cca/pose", "frame `world`, stamped now | 1 2 3 | 0 0 0.6 0.8",
         "10f3786d7d40fd2b54367835614bff85d4ad3b5dab62bf8bca0cc232d73b4cd8");
  expect("Twist", "cca/command", "frame ``, no stamp | 1 2 3 | 4 5 6",
         "9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a");
  expect("TransformStamped", "cca/transform", "frame `world`, stamped now trunk | 1 2 3 | 0 0 0.6 0.8",
         "0a241f87d04668d94099cbb5ba11691d5ad32c2f29682e4eb5653424bd275206");
  expect("TFMessage", "cca/tf", "frame `world`, stamped now trunk | 1 2 3 | 0 0 0.6 0.8",
         "e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087");
  expect("JointTrajectory", "cca/way",
         "frame ``, no stamp hip knee | 0.25 -0.5 | 1 2 | | | 0.5 | 0.5 -1 | 3 4 | | | 1.25",
         "179b33eba59d676f6d967ac71fe35e7ca2f64b2f3928f4a018cec115e213796e");
  expect("Image", "cca/image",
         "frame ``, stamped now rgb8 | 2 4 0 12 | 10 20 30 40 50 60 70 80 90 100 110 120 130 140 150 160 "
         "170 180 190 200 210 220 230 240",
         "d31d41a9a4c4bc8eae9be757b0beed306564f7526c88ea6a4588fb9582527d47");
  CHECK_GT(c.get<"states">().sent(), 0);
  CHECK_EQ(c.get<"states">().dropped(), 0);
}

void all_are_heard_from(const char* program, const std::string& what = "tell") {
  use_own_domain();
  cca::controller<listener> c;
  c.load();
  c.start();
  const auto& here = c.get<"here">();
  const auto expect = [&](const char* type, const char* topic, const auto& found, auto wanted) {
    peer other(program, what, type, topic);
    CAPTURE(type);
    CHECK(within_seconds(30, [&] {
      c.step();
      return found.isApprox(wanted, 1e-15);
    }));
  };
  numbers_of<joints> joint_state;
  joint_state << 0.25, -0.5, 1, 2, 3, 4;  // found by name
  expect("JointState", "cca/joint_state", here.joint_state, joint_state);
  numbers_of<inertial> imu;
  imu << 0, 0, 0.6, 0.8, 1, 2, 3, 4, 5, 9.81;
  expect("Imu", "cca/imu", here.imu, imu);
  numbers_of<loads> six;
  six << 4, 5, 6, 1, 2, 3;
  expect("WrenchStamped", "cca/wrench", here.wrench, six);
  expect("TwistStamped", "cca/twist", here.twist, six);
  expect("Float64MultiArray", "cca/array", here.data, Eigen::Vector2d(7, 8));
  const auto& others = c.get<"others">();
  const auto where = other_source::where();
  expect("PoseStamped", "cca/pose", others.pose, where);
  expect("Twist", "cca/command", others.command, six);
  expect("TransformStamped", "cca/transform", others.transform, where);
  expect("TFMessage", "cca/tf", others.tree, where);  // after the transform of another frame
  numbers_of<ways> trajectory;
  trajectory << 0.5, 1.25, 1.25, other_source::angles(), other_source::velocities();  // the last is repeated
  expect("JointTrajectory", "cca/way", others.trajectory, trajectory);
  expect("Image", "cca/image", others.image, other_source::colour());
  CHECK_EQ(c.get<"tree">().refused(), 0);
  CHECK_EQ(c.get<"way">().refused(), 0);
  CHECK_EQ(c.get<"joints">().refused(), 0);
  CHECK_GT(c.get<"joints">().received(), 0);
}

struct last_place {
  numbers_of<places> seen = numbers_of<places>::Zero();
  void process(const cca::in<"place", place>& p) { seen = p.vector(); }
};
// Told once, before anybody is there.
struct once {
  auto process(cca::beat now) -> cca::maybe<"place", place> {
    if (now.index() != 0) return {};
    return other_source::where();
  }
};
struct tells_once
    : cca::graph<cca::rate<100>,
                 cca::node<"where", once>,
                 cca::node<"fixed", cca::ros2::publisher<"cca/tf_static", tree, cca::ros2::transient_local>>,
                 cca::wire<"where.place", "fixed.transform">> {};
struct hears_once
    : cca::graph<cca::rate<100>,
                 cca::node<"fixed", cca::ros2::subscriber<"cca/tf_static", tree, cca::ros2::transient_local>>,
                 cca::node<"last", last_place>,
                 cca::wire<"fixed.transform", "last.place">> {};

void what_is_told_once_is_heard_by(const char* program) {
  use_own_domain();
  cca::controller<tells_once> c;
  c.load();
  c.start();
  for (int i = 0; i < 5; ++i) c.step();
  CHECK(within_seconds(10, [&] { return c.get<"fixed">().sent() == 1; }));
  peer other(program, "hear", "TFMessage", "cca/tf_static");
  CHECK(within_seconds(30, [&] { return other.has_said(); }));
  CHECK(other.said.find("trunk") != std::string::npos);
  CHECK(other.said.find("| 1 2 3 | 0 0 0.6 0.8\n") != std::string::npos);
}
void what_is_kept_is_heard_from(const char* program) {
  use_own_domain();
  peer other(program, "tell", "TFMessage", "cca/tf_static");
  cca::controller<hears_once> c;
  c.load();
  c.start();
  CHECK(within_seconds(30, [&] {
    c.step();
    return c.get<"last">().seen.isApprox(other_source::where(), 1e-15);
  }));
}

}  // namespace

TEST_SUITE("ros 2 and other programs") {
  TEST_CASE("a program on generated code hears what is published") { all_are_heard_by(idlc_peer, true); }
  TEST_CASE("a program on Fast DDS hears what is published") { all_are_heard_by(fast_dds_peer, false); }
  TEST_CASE("what a program on generated code publishes is heard") { all_are_heard_from(idlc_peer); }
  TEST_CASE("what a program on Fast DDS publishes is heard") { all_are_heard_from(fast_dds_peer); }
  TEST_CASE("what is kept on tf_static goes both ways") {
    what_is_told_once_is_heard_by(idlc_peer);
    what_is_told_once_is_heard_by(fast_dds_peer);
    what_is_kept_is_heard_from(idlc_peer);
    what_is_kept_is_heard_from(fast_dds_peer);
  }
  TEST_CASE("what a program on a big-endian machine publishes is heard") {
    all_are_heard_from(fast_dds_peer, "big");
  }
}
