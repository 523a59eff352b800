// Messages of ROS 2 beside the samples: which fit a space, and what is in them, read with a reader of its
// own.
#include <doctest/doctest.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "graphs.hpp"

using namespace record_test;
using cca::recording::detail::cdr_reader;
using cca::recording::detail::viewer_message;

namespace {

struct trunk : cca::frame<"trunk"> {};
struct foot : cca::frame<"foot"> {};
template <class Domain, class... Axes>
struct over : cca::space<Domain, cca::axes<Axes...>> {};

template <class Space>
viewer_message message() {
  return viewer_message(cca::detail::space_of<Space>);
}
template <class Space>
std::string type_of() {
  return std::string(message<Space>().type());
}

constexpr std::int64_t origin = 3'000'000'007;

// What comes after the head, whose stamp and frame it checks.
template <class Space>
std::vector<double> numbers(const std::string& frame, const std::vector<double>& sample) {
  viewer_message m = message<Space>();
  cdr_reader from(m.made_of(sample.data(), origin));
  CHECK(from.number<std::int32_t>() == 3);
  CHECK(from.number<std::uint32_t>() == 7);
  CHECK(from.text() == frame);
  std::vector<double> all;
  while (!from.is_bad() && !from.is_at_end()) all.push_back(from.number<double>());
  CHECK(!from.is_bad());
  return all;
}

using numbers_of = std::vector<double>;

}  // namespace

TEST_CASE("the joints of a message are the axes, and the domain type says which field is filled") {
  viewer_message m = message<leg_angles>();
  CHECK(m.type() == "sensor_msgs/msg/JointState");
  const double sample[] = {0.25, -0.5};
  cdr_reader from(m.made_of(sample, origin));
  from.number<std::int32_t>(), from.number<std::uint32_t>();
  CHECK(from.text() == "");
  CHECK(from.number<std::uint32_t>() == 2);
  CHECK(from.text() == "hip");
  CHECK(from.text() == "knee");
  CHECK(from.number<std::uint32_t>() == 2);  // position
  CHECK(from.number<double>() == 0.25);
  CHECK(from.number<double>() == -0.5);
  CHECK(from.number<std::uint32_t>() == 0);  // velocity
  CHECK(from.number<std::uint32_t>() == 0);  // effort
  CHECK(from.is_at_end());

  for (const bool is_torque : {false, true}) {
    viewer_message other =
        is_torque ? message<over<cca::joint_torques, hip>>() : message<over<cca::joint_velocities, hip>>();
    const double value[] = {1.5};
    cdr_reader in(other.made_of(value, origin));
    in.number<std::int32_t>(), in.number<std::uint32_t>(), in.text(), in.number<std::uint32_t>(), in.text();
    CHECK(in.number<std::uint32_t>() == 0);  // position
    CHECK(in.number<std::uint32_t>() == (is_torque ? 0 : 1));
    if (!is_torque) CHECK(in.number<double>() == 1.5);
    CHECK(in.number<std::uint32_t>() == (is_torque ? 1 : 0));
    if (is_torque) CHECK(in.number<double>() == 1.5);
    CHECK(in.is_at_end());
  }
}

TEST_CASE("points, orientations, poses, twists and wrenches carry their frame") {
  using cca::x, cca::y, cca::z;
  CHECK(type_of<over<cca::cartesian_position<trunk>, x, y, z>>() == "geometry_msgs/msg/PointStamped");
  CHECK(numbers<over<cca::cartesian_position<trunk>, x, y, z>>("trunk", {1, 2, 3}) == numbers_of{1, 2, 3});
  CHECK(numbers<over<cca::cartesian_position<trunk>, z, x>>("trunk", {3, 1}) == numbers_of{1, 0, 3});
  CHECK(type_of<over<cca::orientation<trunk>, x, y, z>>() == "geometry_msgs/msg/QuaternionStamped");
  CHECK(numbers<over<cca::orientation<trunk>, x, y, z>>("trunk", {0, 0, 0.6, 0.8}) ==
        numbers_of{0, 0, 0.6, 0.8});
  CHECK(type_of<over<cca::pose<trunk>, x, y, z>>() == "geometry_msgs/msg/PoseStamped");
  CHECK(numbers<over<cca::pose<trunk>, x, y, z>>("trunk", {1, 2, 3, 0, 0, 0, 1}) ==
        numbers_of{1, 2, 3, 0, 0, 0, 1});
  CHECK(type_of<over<cca::twist<foot, trunk>, x, y, z>>() == "geometry_msgs/msg/TwistStamped");
  CHECK(numbers<over<cca::twist<foot, trunk>, x, y, z>>("trunk", {1, 2, 3, 4, 5, 6}) ==
        numbers_of{4, 5, 6, 1, 2, 3});
  CHECK(type_of<over<cca::wrench<foot, foot>, x, y, z>>() == "geometry_msgs/msg/WrenchStamped");
  CHECK(numbers<over<cca::wrench<foot, foot>, x, y, z>>("foot", {1, 2, 3, 4, 5, 6}) ==
        numbers_of{4, 5, 6, 1, 2, 3});
}

TEST_CASE("a space that no message fits has none") {
  CHECK(!message<steps>().fits());
  CHECK(!message<over<cca::joint_stiffness, hip>>().fits());
  CHECK(!message<over<cca::wrench<foot, trunk>, cca::x, cca::y, cca::z>>().fits());  // about another point
}

TEST_CASE("views are written at their own rate, and a replay does not mind them") {
  const temporary_file file("views");
  for (const double hz : {50.0, 0.0}) {
    CAPTURE(hz);
    {
      cca::controller<walking<>> c;
      cca::recording::settings s;
      s.viewer_hz = hz;
      s.waits = true;
      cca::recording::recorder recording(c, file.path, s);
      c.load();
      c.start();
      c.run(cca::for_beats<500>{});
      c.stop();
    }
    std::map<std::string, int> count;
    cca::recording::mcap_reader all(file.path);
    for (cca::recording::mcap_message m; all.next(m);) ++count[all.channels().at(m.channel).topic];
    CHECK(count["/leg/angles"] == 500);
    CHECK(count["/ros2/leg/angles"] == (hz > 0 ? 25 : 0));
    CHECK(cca::recording::replay<walking<>>(file.path));
  }
}
