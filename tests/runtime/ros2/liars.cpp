// Messages under the right names that can't be used: each is refused and counted, and changes nothing.
#include <doctest/doctest.h>

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
        writer(dds_create_writer(in.writes(), on.get(), qos_of(true, 10, type.hash).get(), nullptr), "liar") {
  }

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
