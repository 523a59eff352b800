// Messages under the right names that can't be used: each is refused and counted, and changes nothing.
#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "peer.hpp"
#include "spaces.hpp"

using namespace ros2_test;
using namespace cca::ros2::detail;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

// A JointState that holds its own memory.
struct joint_message {
  std::vector<std::string> names{"hip", "knee"};
  std::vector<double> position{0.25, -0.5}, velocity{1, 2}, effort{3, 4};

  joint_state_message made() {
    letters.clear();
    for (auto& name : names) letters.push_back(name.data());
    joint_state_message m;
    m.head.frame_id = frame;
    m.name = borrowed(letters.data(), letters.size());
    m.position = borrowed(position.data(), position.size());
    m.velocity = borrowed(velocity.data(), velocity.size());
    m.effort = borrowed(effort.data(), effort.size());
    return m;
  }

  std::vector<char*> letters{};
  char frame[1] = {};
};

std::string why_refused(joint_message m) {
  numbers_of<joints> to;
  const char* const why = joints::read(m.made(), to.data());
  return why ? why : "";
}

struct recorder {
  int count = 0;
  bool is_finite = true;
  Eigen::Vector2d last{0, 0};
  void process(const cca::in<"angles", leg_angles>& q) {
    ++count;
    is_finite = is_finite && q.vector().allFinite();
    last = q.vector();
  }
};

struct listener : cca::graph<cca::rate<1000>,
                             cca::node<"joints", cca::ros2::subscriber<"cca/lies", joints>>,
                             cca::node<"here", recorder>,
                             cca::wire<"joints.position", "here.angles">> {};

// Publishes what it is given under the name of JointState.
class liar {
public:
  explicit liar(const message_type& type = joints::type)
      : in(static_cast<std::uint32_t>(std::stoul(domain())), ""),
        on(in, "rt/cca/lies", type_name_in_dds(type.name), type),
        writer(dds_create_writer(in.writes(), on.get(), qos_of({true, false, 10}, type.hash).get(), nullptr),
               "liar") {}

  void tell(const void* message) const { dds_write(writer.get(), message); }

private:
  cca::dds::detail::participant in;
  message_topic on;
  cca::dds::detail::entity writer;
};

struct heard {
  cca::controller<listener> c;
  heard() {
    use_own_domain();
    c.load();
    c.start();
  }
  auto& joints() { return c.get<"joints">(); }
  auto& here() { return c.get<"here">(); }

  // Tells it until it is refused.
  std::string refusal_of(const liar& from, const void* message) {
    const auto before = joints().refused();
    within_seconds(20, [&] {
      from.tell(message);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      c.step();
      return joints().refused() > before;
    });
    return std::string(joints().why_refused());
  }
};

// JointState and eight bytes more: Cyclone takes its beginning.
struct longer_message {
  joint_state_message begin;
  double more = 1;
};
constexpr std::array longer_fields{
    joint_state_fields[0], joint_state_fields[1],
    joint_state_fields[2], joint_state_fields[3],
    joint_state_fields[4], message_field{"more", kind::float64, offsetof(longer_message, more)},
};
constexpr message_type longer_type{"sensor_msgs/msg/JointState", longer_fields, sizeof(longer_message),
                                   alignof(longer_message)};

}  // namespace

TEST_SUITE("ros 2 liars") {
  TEST_CASE("joints are found by name, in any order, and others are ignored") {
    numbers_of<joints> to;
    joint_message m;
    m.names = {"knee", "tail", "hip"};
    m.position = {-0.5, no_number, 0.25};
    m.velocity = {2, no_number, 1};
    m.effort = {4, no_number, 3};
    REQUIRE_EQ(joints::read(m.made(), to.data()), nullptr);
    numbers_of<joints> wanted;
    wanted << 0.25, -0.5, 1, 2, 3, 4;
    CHECK_EQ(to, wanted);
  }

  TEST_CASE("a JointState that does not fit is refused, with the reason") {
    CHECK_EQ(why_refused({}), "");
    CHECK_EQ(why_refused({.names = {"hip", "ankle"}}), "a joint is missing");
    CHECK_EQ(why_refused({.names = {}, .position = {}, .velocity = {}, .effort = {}}), "a field is missing");
    CHECK_EQ(why_refused({.effort = {}}), "a field is missing");
    CHECK_EQ(why_refused({.velocity = {1}}), "a field of another length than the names");
    CHECK_EQ(why_refused({.velocity = {1, 2, 3}}), "a field of another length than the names");
    CHECK_EQ(why_refused({.names = {"hip", "knee", "hip"},
                          .position = {1, 2, 3},
                          .velocity = {1, 2, 3},
                          .effort = {1, 2, 3}}),
             "a joint is named twice");
  }

  TEST_CASE("an Imu, a wrench, a twist and an array that do not fit are refused, with the reason") {
    double to[10];
    char trunk_name[] = "trunk", other_name[] = "map", no_name[] = "";
    imu_message i;
    i.head.frame_id = trunk_name;
    CHECK_EQ(inertial::read(i, to), nullptr);
    i.orientation = {0, 0, 0, 2};
    CHECK_EQ(std::string(inertial::read(i, to)), "an orientation that is no unit quaternion");
    i.orientation = {0, 0, 0, no_number};
    CHECK_EQ(std::string(inertial::read(i, to)), "an orientation that is no unit quaternion");
    i.orientation = {0, 0, 0, 1.0001};
    CHECK_EQ(inertial::read(i, to), nullptr);
    CHECK_EQ(to[3], 1);
    i.linear_acceleration_covariance[0] = -1;
    CHECK_EQ(std::string(inertial::read(i, to)), "a field without an estimate");
    i.head.frame_id = other_name;
    CHECK_EQ(std::string(inertial::read(i, to)), "another frame_id");

    wrench_message w;
    w.head.frame_id = other_name;
    CHECK_EQ(std::string(loads::read(w, to)), "another frame_id");
    w.head.frame_id = no_name;  // says nothing about its frame
    CHECK_EQ(loads::read(w, to), nullptr);
    twist_message t;
    t.head.frame_id = trunk_name;  // ours is along the axes of the world
    CHECK_EQ(std::string(motions::read(t, to)), "another frame_id");

    double data[] = {1, 2};
    char swapped[] = "knee,hip";
    array_dimension dimension{swapped, 2, 2};
    array_message a;
    a.data = borrowed(data, 2);
    CHECK_EQ(array::read(a, to), nullptr);
    a.layout.dim = borrowed(&dimension, 1);
    CHECK_EQ(std::string(array::read(a, to)), "a layout of something else");
    dimension = {no_name, 2, 2};
    CHECK_EQ(array::read(a, to), nullptr);
    dimension.size = 1;
    CHECK_EQ(std::string(array::read(a, to)), "a layout of something else");
    a.layout = {{}, 1};
    CHECK_EQ(std::string(array::read(a, to)), "a layout of something else");
    a.layout = {};
    a.data.length = 1;
    CHECK_EQ(std::string(array::read(a, to)), "another number of coordinates");
  }

  TEST_CASE(
      "a pose and a transform that do not fit are refused, and what is meant for others is left alone") {
    double to[7];
    char world_name[] = "world", other_name[] = "map", child[] = "trunk", other_child[] = "odom";
    pose_message p;
    p.head.frame_id = world_name;
    CHECK_EQ(places::read(p, to), nullptr);
    p.pose.orientation = {0, 0, 0, 2};
    CHECK_EQ(std::string(places::read(p, to)), "an orientation that is no unit quaternion");
    p.pose.orientation = {0, 0, 0, 1.0001};
    CHECK_EQ(places::read(p, to), nullptr);
    CHECK_EQ(to[6], 1);
    p.head.frame_id = other_name;
    CHECK_EQ(std::string(places::read(p, to)), "another frame_id");

    transform_message t{{{}, world_name}, child, {}};
    CHECK_EQ(transforms::read(t, to), nullptr);
    t.child_frame_id = other_child;
    CHECK_EQ(std::string(transforms::read(t, to)), "another child_frame_id");
    tf_message all{borrowed(&t, 1)};
    CHECK_EQ(tree::read(all, to), is_for_others);
    CHECK_EQ(tree::read(tf_message{}, to), is_for_others);
    t = {{{}, other_name}, child, {}};
    CHECK_EQ(std::string(tree::read(all, to)), "another frame_id");
    t.head.frame_id = world_name;
    t.transform.orientation = {};
    t.transform.orientation.w = 0;
    CHECK_EQ(std::string(tree::read(all, to)), "an orientation that is no unit quaternion");
  }

  TEST_CASE("a trajectory that does not fit is refused, with the reason") {
    char hip_name[] = "hip", knee_name[] = "knee", tail_name[] = "tail";
    char* names[] = {knee_name, hip_name};
    std::vector<double> at{-0.5, 0.25}, moving{2, 1};
    std::vector<trajectory_point> points(2);
    const auto seconds = [](double t) { return duration_of(t); };
    numbers_of<ways> to;
    const auto refusal = [&](auto change) {
      for (auto& point : points) point = {borrowed(at.data(), 2), borrowed(moving.data(), 2), {}, {}, {}};
      points[0].time_from_start = seconds(0.5);
      points[1].time_from_start = seconds(1);
      trajectory_message m;
      m.joint_names = borrowed(names, 2);
      m.points = borrowed(points.data(), 2);
      change(m);
      const char* const why = ways::read(m, to.data());
      return std::string(why ? why : "");
    };
    CHECK_EQ(refusal([](auto&) {}), "");
    numbers_of<ways> wanted;
    wanted << 0.5, 1, 1, 0.25, -0.5, 0.25, -0.5, 0.25, -0.5, 1, 2, 1, 2, 1, 2;
    CHECK_EQ(to, wanted);
    CHECK_EQ(refusal([](auto& m) { m.points.length = 0; }), "no points");
    points.resize(4);
    CHECK_EQ(refusal([](auto& m) { m.points.length = 4; }), "more points than there is room for");
    CHECK_EQ(refusal([&](auto&) { points[1].time_from_start = seconds(0.5); }), "times that do not rise");
    CHECK_EQ(refusal([&](auto&) { points[0].time_from_start.sec = -1; }), "times that do not rise");
    CHECK_EQ(refusal([&](auto&) { points[1].velocities.length = 0; }), "a field is missing");
    CHECK_EQ(refusal([&](auto&) { points[1].effort = borrowed(at.data(), 1); }),
             "a field of another length than the names");
    names[0] = tail_name;
    CHECK_EQ(refusal([](auto&) {}), "a joint is missing");
    names[0] = hip_name;
    CHECK_EQ(refusal([](auto&) {}), "a joint is named twice");
  }

  TEST_CASE("a trajectory is sent up to the last time that rises") {
    ways::maker maker;
    numbers_of<ways> all = numbers_of<ways>::Zero();
    const auto count_of = [&](double a, double b, double c) {
      all[0] = a, all[1] = b, all[2] = c;
      return maker.make(all.data(), 0)->points.length;
    };
    CHECK_EQ(count_of(0, 0, 0), 1);
    CHECK_EQ(count_of(0, 1, 1), 2);
    CHECK_EQ(count_of(0, 1, 2), 3);
    CHECK_EQ(count_of(no_number, 1, 2), 1);
    CHECK_EQ(count_of(-1, 1, 2), 3);
    CHECK_EQ(maker.make(all.data(), 0)->points.buffer[0].time_from_start.sec, 0);
    CHECK_EQ(count_of(1e300, 1, 2), 1);
  }

  TEST_CASE("a picture that does not fit is refused, with the reason, and odd bytes are understood") {
    std::vector<std::uint8_t> bytes(64, 7);
    char rgb[] = "rgb8", mono[] = "mono8", nowhere[] = "";
    numbers_of<pictures> to;
    const auto refusal = [&](auto change) {
      image_message m{{{}, nowhere}, 2, 4, rgb, 0, 12, borrowed(bytes.data(), 24)};
      change(m);
      const char* const why = pictures::read(m, to.data());
      return std::string(why ? why : "");
    };
    CHECK_EQ(refusal([](auto&) {}), "");
    CHECK_EQ(to, numbers_of<pictures>::Constant(7));
    CHECK_EQ(refusal([](auto& m) { m.width = 3; }), "a picture of another size");
    CHECK_EQ(refusal([](auto& m) { m.height = 3; }), "a picture of another size");
    CHECK_EQ(refusal([&](auto& m) { m.encoding = mono; }), "another encoding");
    CHECK_EQ(refusal([](auto& m) { m.step = 11; }), "lengths that do not fit the picture");
    CHECK_EQ(refusal([](auto& m) { m.data.length = 23; }), "lengths that do not fit the picture");
    CHECK_EQ(refusal([](auto& m) { m.step = 0x80000000u; }), "lengths that do not fit the picture");

    pictures::maker maker;
    to = numbers_of<pictures>::Constant(300);
    to[1] = -5, to[2] = 1.5, to[3] = no_number;
    const auto* const sent = maker.make(to.data(), 0);
    CHECK_EQ(sent->data.buffer[0], 255);
    CHECK_EQ(sent->data.buffer[1], 0);
    CHECK_EQ(sent->data.buffer[2], 2);
    CHECK_EQ(sent->data.buffer[3], 0);

    // 1.5 m with its bytes in either order, and nothing measured.
    char float_name[] = "32FC1";
    std::vector<std::uint8_t> far(32, 0);
    for (const bool is_big : {false, true}) {
      const std::uint8_t low[] = {0, 0, 0xc0, 0x3f}, no[] = {0, 0, 0xc0, 0x7f};
      for (std::size_t i = 0; i < 4; ++i) {
        far[i] = low[is_big ? 3 - i : i];
        far[4 + i] = no[is_big ? 3 - i : i];
      }
      const image_message m{{{}, nowhere}, 2, 4, float_name, is_big, 16, borrowed(far.data(), 32)};
      numbers_of<depth_pictures> measured;
      REQUIRE_EQ(depth_pictures::read(m, measured.data()), nullptr);
      CHECK_EQ(measured[0], 1.5);
      CHECK_EQ(measured[1], 0);
    }
  }

  TEST_CASE("what comes over the network and can't be used changes nothing") {
    heard by;
    joint_message m;
    {
      const liar tells_nan;
      m.position = {no_number, 0};
      const auto said = m.made();
      CHECK_EQ(by.refusal_of(tells_nan, &said), "a number that is not finite");

      joint_message many;
      many.names.assign(5000, "a joint of another robot");
      many.position.assign(5000, 1);
      many.velocity = many.effort = many.position;
      const auto long_one = many.made();
      CHECK_EQ(by.refusal_of(tells_nan, &long_one), "longer than 65536 bytes");
    }
    {
      const liar tells_more(longer_type);
      joint_message good;
      const longer_message longer{good.made()};
      CHECK_EQ(by.refusal_of(tells_more, &longer), "longer than a message of this type");
    }
    CHECK_EQ(by.joints().received(), 0);
    CHECK_EQ(by.here().count, 0);
  }

  TEST_CASE("random bytes from another vendor do no harm") {
    dds_set_log_sink([](void*, const dds_log_data_t*) {}, nullptr);  // Cyclone has much to say about it
    heard by;
    {
      const peer other(fast_dds_peer, "lie", "JointState", "cca/lies");
      within_seconds(20, [&] {
        by.c.step();
        return by.joints().refused() > 200;
      });
    }
    CHECK_GT(by.joints().refused(), 200);
    CHECK(by.here().is_finite);
    const peer honest(fast_dds_peer, "tell", "JointState", "cca/lies");
    CHECK(within_seconds(20, [&] {
      by.c.step();
      return by.here().last == Eigen::Vector2d(0.25, -0.5);
    }));
  }

  TEST_CASE("a message that no beat takes in time is dropped") {
    heard by;
    const liar honest;
    joint_message m;
    const auto said = m.made();
    REQUIRE(within_seconds(20, [&] {
      honest.tell(&said);
      by.c.step();
      return by.here().count > 0;
    }));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    by.c.step();  // takes what is left
    const int count = by.here().count;
    honest.tell(&said);
    CHECK(within_seconds(5, [&] { return by.joints().too_late() == 1; }));
    by.c.step();
    CHECK_EQ(by.here().count, count);
    honest.tell(&said);
    CHECK(within_seconds(5, [&] {
      by.c.step();
      return by.here().count > count;
    }));
  }
}
