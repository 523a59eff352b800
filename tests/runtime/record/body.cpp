// A recording shows the body of a robot: /tf from its kinematics, and a description that viewers read.
#include <doctest/doctest.h>

#include <map>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <cca/graph/items/shows.hpp>
#include <cca/robot/body_pose.hpp>

#include "graphs.hpp"

using namespace record_test;
using cca::recording::detail::cdr_reader;

namespace {

struct trunk : cca::frame<"trunk"> {};
struct world : cca::frame<"world"> {};
struct foot : cca::frame<"foot"> {};
struct rail : cca::dimension<"rail"> {
  static constexpr auto limits = cca::limits{cca::angle{-2.0, 2.0}};
};

// The knee turns against its axis, and moves a second joint, as in a pantograph; a slider at the end.
struct chain : cca::serial_chain<trunk, foot, cca::axes<hip, knee, rail>> {
  static constexpr std::array joints{
      cca::revolute(cca::along_y, cca::at(0.1, 0.2, 0) * cca::turned_about(cca::along_z, 0.3)),
      cca::revolute({0, 1, 1}, cca::at(0, 0, -0.3)).driven_by(1, -1),
      cca::revolute(cca::along_x, cca::at(0, 0, -0.2)).driven_by(1, 0.5, 0.1),
      cca::prismatic(cca::along_z, cca::at(0.05, 0, 0)).driven_by(2)};
  static constexpr cca::placement tip = cca::at(0, 0, -0.1);
  static constexpr std::array links{cca::link_inertia{1, {0, 0, -0.15}, {0.01, 0.02, 0.03, 0.001, 0, 0}},
                                    cca::link_inertia{0.5, {}, {0.01, 0.01, 0.01}},
                                    cca::link_inertia{0.5, {}, {0.01, 0.01, 0.01}}, cca::link_inertia{}};
};
struct one_leg : cca::body<trunk, cca::part<"leg", chain>> {
  static constexpr cca::link_inertia base{3, {}, {0.1, 0.1, 0.1}};
};

struct three_angles : cca::space<cca::joint_angles, cca::axes<rail, hip, knee>, cca::rate<1000>> {};
struct attitude : cca::space<cca::orientation<world>, cca::axes<cca::x, cca::y, cca::z>, cca::rate<1000>> {};

struct standing_leg {
  auto sense(cca::beat now) -> std::tuple<cca::out<"angles", three_angles>, cca::out<"attitude", attitude>> {
    const double t = 1e-9 * static_cast<double>(now.time());
    return {Eigen::Vector3d(0.1 + t, 0.2 - t, -0.7 + t), Eigen::Vector4d(0, 0, std::sin(t), std::cos(t))};
  }
};
struct stands : cca::graph<cca::rate<1000>, cca::node<"leg", standing_leg>, cca::observe<"leg.*">> {};
struct shown : stands, cca::recordable, cca::shows<one_leg, "leg.angles", "leg.attitude"> {};
// The same leg in an inner graph, which exposes what is shown.
struct inner_leg : cca::graph<cca::node<"joints", standing_leg>,
                              cca::expose<"joints.angles", "angles">,
                              cca::expose<"joints.attitude", "attitude">> {};
struct robot_of_graphs : cca::graph<cca::node<"leg", inner_leg>,
                                    cca::expose<"leg.angles", "angles">,
                                    cca::expose<"leg.attitude", "attitude">> {};
struct stands_within
    : cca::graph<cca::rate<1000>, cca::node<"robot", robot_of_graphs>, cca::observe<"robot.**.*">> {};
struct shown_within : stands_within,
                      cca::recordable,
                      cca::shows<one_leg, "robot.angles", "robot.leg.attitude"> {};

using cca::detail::shown_ports_of;
static_assert(shown_ports_of<shown_within>.angles == 0 && shown_ports_of<shown_within>.orientation == 1);
static_assert(cca::check<shown>() && cca::check<shown_within>());

struct without_port : stands, cca::recordable, cca::shows<one_leg, "leg.angle"> {};
struct without_inner : stands_within, cca::recordable, cca::shows<one_leg, "robot.angels"> {};
struct far_off : stands, cca::recordable, cca::shows<one_leg, "leg.angles", "imu"> {};
struct without_axis : stands, cca::recordable, cca::shows<one_leg, "leg.attitude"> {};
struct without_orientation : stands, cca::recordable, cca::shows<one_leg, "leg.angles", "leg.angles"> {};

template <class Graph>
constexpr std::string_view mistake_of = shown_ports_of<Graph>.mistake.view();
static_assert(mistake_of<without_port> ==
              "recording.unknown_port: cca::shows names `leg.angle`, which is no output of without_port; did "
              "you mean `leg.angles`?");
static_assert(mistake_of<without_inner> ==
              "recording.unknown_port: cca::shows names `robot.angels`, which is no output of without_inner; "
              "did you mean `robot.angles`?");
static_assert(mistake_of<far_off> ==
              "recording.unknown_port: cca::shows names `imu`, which is no output of far_off: give the path "
              "of an output, as in `robot.angles`");
static_assert(
    mistake_of<without_axis> ==
    "recording.wrong_port: cca::shows names `leg.attitude` for the angles, but attitude "
    "(orientation<world> over x, y, z at 1000 Hz) lacks the axis `hip` of the body one_leg: name an "
    "output with all of its axes");
static_assert(mistake_of<without_orientation> ==
              "recording.wrong_port: cca::shows names `leg.angles` for the orientation of the base, but "
              "three_angles (joint_angles over rail, hip, knee at 1000 Hz) is none: name an output whose "
              "space is a cca::orientation<...>");

struct transform {
  std::string parent;
  Eigen::Vector3d at;
  Eigen::Quaterniond turn;
};
std::map<std::string, transform> transforms_in(const std::vector<unsigned char>& message) {
  std::map<std::string, transform> all;
  cdr_reader from(message);
  for (auto n = from.number<std::uint32_t>(); n > 0; --n) {
    from.number<std::int32_t>(), from.number<std::uint32_t>();
    transform one;
    one.parent = from.text();
    const std::string child(from.text());
    for (int c = 0; c < 3; ++c) one.at[c] = from.number<double>();
    for (int c = 0; c < 4; ++c) one.turn.coeffs()[c] = from.number<double>();
    all[child] = one;
  }
  CHECK(from.is_at_end());
  return all;
}

template <class Graph>
void record(const std::string& file, int beats) {
  cca::controller<Graph> c;
  cca::recording::recorder recording(c, file, {.waits = true});
  c.load();
  c.start();
  for (int k = 0; k < beats; ++k) c.step();
}

}  // namespace

TEST_CASE("/tf has the forward kinematics of the body, at the rate of viewers") {
  const temporary_file file("tf");
  record<shown>(file.path, 201);
  int count = 0, descriptions = 0;
  std::string urdf;
  std::vector<unsigned char> last;
  cca::recording::mcap_reader all(file.path);
  for (cca::recording::mcap_message m; all.next(m);) {
    const std::string& topic = all.channels().at(m.channel).topic;
    if (topic == "/robot_description") ++descriptions, urdf = cdr_reader(m.data).text();
    if (topic != "/tf") continue;
    CHECK(descriptions == 1);  // before
    ++count;
    last.assign(m.data.begin(), m.data.end());
  }
  CHECK(count == 11);
  const auto frames = transforms_in(last);  // of beat 200
  REQUIRE(frames.size() == 6);
  CHECK(frames.at("trunk").parent == "world");
  CHECK(frames.at("leg_0").parent == "trunk");
  CHECK(frames.at("leg_3").parent == "leg_2");
  Eigen::Isometry3d tip = Eigen::Isometry3d::Identity();
  std::string at = "foot";
  while (at != "world") {
    const transform& t = frames.at(at);
    tip = Eigen::Translation3d(t.at) * t.turn * tip;
    at = t.parent;
  }
  const cca::body_pose<one_leg> now(Eigen::Vector3d(0, -0.5, 0.3));  // hip, knee, rail
  const Eigen::Quaterniond base(std::cos(0.2), 0, 0, std::sin(0.2));
  CHECK((tip.translation() - base * now.tip<"leg">().at).norm() < 1e-12);
  CHECK((tip.linear() - base.toRotationMatrix() * now.tip<"leg">().turn).norm() < 1e-12);

  const auto has = [&](const std::string& text) { return urdf.find(text) != urdf.npos; };
  CHECK(has("<joint name=\"hip\" type=\"revolute\">"));
  CHECK(has("<limit lower=\"-0.5\" upper=\"0.5\""));
  CHECK(has("<axis xyz=\"0 -0.707106781187 -0.707106781187\"/>"));  // the knee, against its axis
  CHECK(has("<mimic joint=\"knee\" multiplier=\"0.5\" offset=\"0.1\"/>"));
  CHECK(has("<joint name=\"rail\" type=\"prismatic\">"));
  CHECK(has("<mass value=\"3\"/>"));
  CHECK(has("<inertia ixx=\"0.01\" iyy=\"0.02\" izz=\"0.03\" ixy=\"0.001\""));
  CHECK(cca::recording::replay<shown>(file.path));
}

TEST_CASE("the ports of the body may be those that inner graphs expose") {
  const temporary_file plain("shown"), within("shown_within");
  record<shown>(plain.path, 101);
  record<shown_within>(within.path, 101);
  const auto transforms = [](const std::string& file) {
    std::vector<std::vector<unsigned char>> found;
    cca::recording::mcap_reader all(file);
    for (cca::recording::mcap_message m; all.next(m);)
      if (all.channels().at(m.channel).topic == "/tf") found.emplace_back(m.data.begin(), m.data.end());
    return found;
  };
  CHECK(transforms(plain.path).size() == 6);
  CHECK(transforms(plain.path) == transforms(within.path));
}
