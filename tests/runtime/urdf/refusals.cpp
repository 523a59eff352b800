// What cca-urdf refuses or leaves out, in words: broken files, robots that no engine can move, names.
#include <array>
#include <cerrno>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <string_view>

#include <doctest/doctest.h>

#include "../../../tools/urdf/conversion.hpp"

namespace {

using cca_urdf::convert;

// Line 1 is the robot; lines 2 to 9 a base, an arm and the joint between them.
const std::string good = R"(<robot name="r">
<link name="base"/>
<link name="arm"><inertial><origin xyz="0 0 0.1"/><mass value="2"/>
<inertia ixx="0.02" iyy="0.02" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="shoulder" type="revolute">
<parent link="base"/><child link="arm"/>
<origin xyz="0 0 1"/><axis xyz="0 1 0"/>
<limit effort="10" velocity="2" lower="-1" upper="1"/>
</joint>
</robot>
)";

std::string with(std::string_view from, std::string_view to) {
  std::string text = good;
  const auto at = text.find(from);
  REQUIRE(at != text.npos);
  return text.replace(at, from.size(), to);
}

std::string said(std::string_view text, const cca_urdf::options& o = {}) {
  return cca_urdf::text_of(convert(text, o).said, "f");
}

bool has(const std::string& text, std::string_view words) {
  INFO(text);
  const bool found = text.find(words) != text.npos;
  CHECK(found);
  return found;
}

// Refused, with these words.
void refused(const std::string& text, std::string_view words) {
  const auto made = convert(text, {});
  CHECK(made.header.empty());
  has(cca_urdf::text_of(made.said, "f"), words);
}
// Written, with these words.
std::string noted(const std::string& text, std::string_view words) {
  const auto made = convert(text, {});
  INFO(cca_urdf::text_of(made.said, "f"));
  CHECK_FALSE(made.header.empty());
  has(cca_urdf::text_of(made.said, "f"), words);
  return made.header;
}

std::string file(const char* name) {
  std::ifstream in(std::string(CCA_URDF) + "/" + name + ".urdf");
  std::ostringstream text;
  text << in.rdbuf();
  REQUIRE(text.str().size() > 100);
  return text.str();
}

const std::string hand = R"(<link name="hand"><inertial><mass value="1"/>
<inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="wrist" type="prismatic"><parent link="arm"/><child link="hand"/>
<limit effort="1" velocity="1" lower="0" upper="1"/></joint></robot>)";

}  // namespace

TEST_SUITE("refusals") {
  TEST_CASE("the file from which the others are made is good") {
    const auto made = convert(good, {});
    CHECK(made.said.empty());
    CHECK_FALSE(made.header.empty());
  }

  TEST_CASE("no beginning of a file is a file") {
    for (const char* name : {"panda", "ur5e", "solo12", "crooked"}) {
      const std::string whole = file(name);
      const std::size_t end = whole.rfind('>') + 1;
      for (std::size_t size = 0; size < end; size += size < 3000 || size + 200 > end ? 1 : 7) {
        const auto made = convert(std::string_view(whole).substr(0, size), {});
        REQUIRE(made.header.empty());
        REQUIRE_FALSE(made.said.empty());
      }
      CHECK_FALSE(convert(std::string_view(whole).substr(0, end), {}).header.empty());
    }
  }

  TEST_CASE("a file without one of its bytes is refused or still finite") {
    for (std::size_t i = 0; i < good.size(); ++i) {
      std::string text = good;
      text.erase(i, 1);
      const auto made = convert(text, {});
      CHECK(made.header.find("nan") == std::string::npos);
      if (made.header.empty()) CHECK_FALSE(made.said.empty());
    }
  }

  TEST_CASE("what is no URDF") {
    refused("", "f: error: this is not XML");
    refused("no xml", "f");
    refused("<sdf version=\"1\"></sdf>", "f:1: error: a URDF file is one <robot>");
    refused("<robot name=\"\"></robot>", "<robot> needs `name`");
    refused("<robot name=\"r\"></robot>", "the robot has no <link>");
    refused(good + "<robot name=\"s\"></robot>", "stands after the <robot>");
    refused(with("<mass value=\"2\"/>", "<mass value=\"2\"/><mass value=\"3\"/>"),
            "f:3: error: <inertial> (line 3) has a second <mass>");
    refused(std::string("<robot name=\"a\0\"></robot>", 25), "byte 14 is 0");
    refused(with("<link name=\"base\"/>", "<xacro:include filename=\"x\"/><link name=\"base\"/>"),
            "f:2: error: <xacro:include> is for xacro: expand the file first");
    refused(with("<mass value=\"2\"/>", "<mass value=\"2\" value=\"3\"/>"), "f:3: error: this is not XML");
    std::string deep = "<robot name=\"r\">";
    for (int i = 0; i < 100000; ++i) deep += "<a>";
    refused(deep, "f");
  }

  TEST_CASE("numbers") {
    for (const char* wrong : {"nan", "inf", "-inf", "1e999", "0x10", "2,5", "2 kg", "", "two", "${m}"})
      refused(with("mass value=\"2\"", "mass value=\"" + std::string(wrong) + "\""),
              std::string("link 'arm': <mass> has value=\"") + wrong + "\", which is no finite number");
    refused(with("xyz=\"0 1 0\"", "xyz=\"0 NaN 0\""),
            "f:7: error: joint 'shoulder': <axis> has xyz=\"0 NaN 0\"");
    refused(with("xyz=\"0 1 0\"", "xyz=\"0 1\""), "which is not 3 finite numbers");
    refused(with("xyz=\"0 1 0\"", "xyz=\"0 0 0\""), "the axis has no direction");
    refused(with(" ixy=\"0\"", ""), "f:4: error: link 'arm': <inertia> needs `ixy`");
    noted(with("mass value=\"2\"", "mass value=\" +2e0 \""), "");
  }

  TEST_CASE("masses and inertias") {
    refused(with("mass value=\"2\"", "mass value=\"-2\""), "f:3: error: link 'arm': a mass of -2 kg");
    refused(with("<mass value=\"2\"/>", ""), "<inertial> needs a <mass>");
    refused(with("izz=\"0.01\"", "izz=\"-0.01\""),
            "its principal moments are -0.01, 0.02 and 0.02 kg m^2, and");
    refused(
        with("izz=\"0.01\"", "izz=\"0.05\""),
        "its principal moments are 0.02, 0.02 and 0.05 kg m^2: the largest is above the sum of the others");
    refused(with("ixy=\"0\"", "ixy=\"0.03\""), "none may be negative");
    refused(with("izz=\"0.01\"", "izz=\"0\""), "link 'arm' has an inertia that is not positive definite");
    refused(
        with("izz=\"0.01\"", "izz=\"0.041\""),
        "or let --accept-inertia take the nearest sound one, with principal moments of 0.02035, 0.02035 and "
        "0.04065 kg m^2");
    noted(with("izz=\"0.01\"", "izz=\"0.04\""), "");  // a disc
    refused(with("<link name=\"arm\">", "<link name=\"arm\"/><link name=\"other\">"),
            "no joint holds these links");
    cca_urdf::options floats;
    floats.floats = true;
    has(said(good, floats), "f:2: error: link 'base' has no mass, but the base floats");
  }

  TEST_CASE("the masses of fixed links count") {
    const std::string text = with("</robot>", R"(<link name="tool"><inertial><mass value="2"/>
<inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="mount" type="fixed"><parent link="arm"/><child link="tool"/><origin xyz="0 0 0.3"/></joint></robot>)");
    // Two points of 2 kg, each 0.1 m from their centre.
    has(noted(text, ""), "cca::link_inertia{4, {0, 0, 0.2}, {0.06, 0.06, 0.01, 0, 0, 0}}");
  }

  TEST_CASE("an inertia that no body has becomes the nearest one that a body can have, if the user says so") {
    const auto sound = [](const std::array<double, 3>& given) {
      const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d(1, 2, 3).normalized());
      const Eigen::Matrix3d about =
          turn * Eigen::Vector3d(given[0], given[1], given[2]).asDiagonal() * turn.inverse();
      const Eigen::Matrix3d found = cca_urdf::nearest_sound(about, 2);
      CHECK(cca_urdf::fault_of(found).empty());
      CHECK(cca_urdf::is_positive_definite(found));
      // Nothing sound is nearer, but for the margin.
      const double off = (found - about).norm();
      std::mt19937 bits(1);
      std::uniform_real_distribution<double> random(-0.05, 0.05);
      for (int i = 0; i < 2000; ++i) {
        Eigen::Matrix3d other;
        for (double& x : other.reshaped()) x = random(bits);
        other = (found + other + other.transpose()).eval();
        if (cca_urdf::fault_of(other).empty() && cca_urdf::is_positive_definite(other))
          CHECK((other - about).norm() > off - 0.004);
      }
      return Eigen::Vector3d(cca_urdf::principal_moments(found));
    };
    CHECK((sound({1, 1, 2.3}) - Eigen::Vector3d(1.1, 1.1, 2.2)).norm() < 0.01);
    CHECK((sound({1, 1, 0}) - Eigen::Vector3d(0, 1, 1)).norm() < 0.01);
    CHECK((sound({1, 1, -1}) - Eigen::Vector3d(0, 1, 1)).norm() < 0.01);
    CHECK((sound({0, 0, 1}) - Eigen::Vector3d(1, 1, 2) / 3).norm() < 0.01);
    CHECK(sound({-1, -1, -1}).norm() < 0.01);
    // A ball of 2 kg of water.
    CHECK(sound({0, 0, 0})[0] == doctest::Approx(0.4 * 2 * 0.0782 * 0.0782).epsilon(0.01));

    cca_urdf::options accepts;
    accepts.accept_inertia = true;
    for (const char* izz : {"0.041", "0.05", "0", "-0.01"}) {
      const auto made = convert(with("izz=\"0.01\"", "izz=\"" + std::string(izz) + "\""), accepts);
      CHECK_FALSE(made.header.empty());
      has(cca_urdf::text_of(made.said, "f"), "f:3: note: link 'arm'");
      has(cca_urdf::text_of(made.said, "f"), "it becomes the nearest sound one, with principal moments of");
    }
    CHECK(convert(good, accepts).said.empty());
  }

  TEST_CASE("what rounding has left of an inertia of zeros is none") {
    cca_urdf::options accepts;
    accepts.accept_inertia = true;
    for (const char* ixx : {"4.1e-18", "0"}) {
      for (const char* izz : {"4.1e-18", "-1.8e-22", "0"}) {
        const std::string text =
            with("ixx=\"0.02\" iyy=\"0.02\" izz=\"0.01\"",
                 std::string("ixx=\"") + ixx + "\" iyy=\"" + ixx + "\" izz=\"" + izz + "\"");
        refused(text, "f:3: error: link 'arm'");
        refused(text, "let --accept-inertia take that of a ball as dense as water");
        const auto made = convert(text, accepts);
        has(made.header, "{0.004887");  // kg m^2, of 2 kg of water
      }
    }
    refused(
        with("ixx=\"0.02\" iyy=\"0.02\" izz=\"0.01\"", "ixx=\"1e-12\" iyy=\"1e-12\" izz=\"1e-12\""),
        "f:3: error: link 'arm' has next to no inertia for its 2 kg, but joint 'shoulder' (line 5) moves it");
    // A bead of a milligram is light, and sound.
    noted(with("<mass value=\"2\"/>\n<inertia ixx=\"0.02\" iyy=\"0.02\" izz=\"0.01\"",
               "<mass value=\"1e-6\"/>\n<inertia ixx=\"1e-13\" iyy=\"1e-13\" izz=\"1e-13\""),
          "");
  }

  TEST_CASE("an angle that is nearly right is a right one") {
    const auto written = [](const std::string& angle) {
      const std::string header = noted(with("xyz=\"0 0 1\"", "xyz=\"0 0 1\" rpy=\"" + angle + " 0 0\""), "");
      return header.substr(header.find("joints{"));
    };
    for (const char* angle : {"1.5708", "1.57079", "1.570796327"})
      CHECK(written(angle) == written("1.5707963267948966"));
    has(said(with("xyz=\"0 0 1\"", "xyz=\"0 0 1\" rpy=\"0 -3.14159 0\"")),
        "f:7: note: joint 'shoulder': the angle -3.14159 of an <origin> becomes -3.141592653589793: it is "
        "within 1e-5 of a multiple of a right angle");
    CHECK(said(with("xyz=\"0 0 1\"", "xyz=\"0 0 1\" rpy=\"1.5709 0 0.1\"")).empty());
  }

  TEST_CASE("the inertia of a body counts, not that of each of its links") {
    const std::string placeholder = R"(<link name="camera"><inertial><mass value="1e-6"/>
<inertia ixx="1e-6" iyy="1e-6" izz="1e-6" ixy="1e-6" ixz="1e-6" iyz="1e-6"/></inertial></link>)";
    const auto on = [&](const char* link) {
      return with("</robot>", placeholder + R"(<joint name="mount" type="fixed"><parent link=")" + link +
                                  R"("/><child link="camera"/></joint></robot>)");
    };
    noted(on("arm"),
          "f:10: note: link 'camera': no body has this inertia: its principal moments are 0, 0 and");
    noted(on("arm"), "it is taken as it is, since link 'arm' with the link fixed to it has a sound one");
    // Nothing moves the base.
    noted(on("base"), "f:2: note: link 'base' with the link fixed to it: no body has this inertia");
    noted(on("base"), "and nothing moves it");
    cca_urdf::options floats;
    floats.floats = true;
    has(said(on("base"), floats),
        "f:2: error: link 'base' with the link fixed to it: no body has this inertia");
    // Too much for the arm.
    std::string heavy = on("arm");
    heavy.replace(heavy.find("izz=\"1e-6\""), 10, "izz=\"1\"");
    refused(heavy, "f:3: error: link 'arm' with the link fixed to it: no body has this inertia");
    const std::string foot = with("</robot>", R"(<link name="foot"><inertial><mass value="0"/>
<inertia ixx="1e-5" iyy="1e-5" izz="1e-5" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="mount" type="fixed"><parent link="arm"/><child link="foot"/></joint></robot>)");
    has(noted(foot, "f:11: note: link 'foot': an inertia without a mass is left out"),
        "cca::link_inertia{2, {0, 0, 0.1}, {0.02, 0.02, 0.01, 0, 0, 0}}");
  }

  TEST_CASE("a robot without masses has kinematics") {
    const std::string bare =
        "<robot name=\"r\"><link name=\"base\"/><link name=\"arm\"/>" + good.substr(good.find("<joint"));
    const std::string header = noted(bare, "f: note: no link that moves has a mass");
    has(header, "check_without_masses<description>");
    has(header, "cca::angle{-1, 1}");
    CHECK(header.find("link_inertia") == std::string::npos);
    // Only a part of it weighs something.
    const std::string half =
        with("</robot>", R"(<link name="hand"/><joint name="wrist" type="revolute"><parent link="arm"/>
<child link="hand"/><limit effort="1" velocity="1" lower="0" upper="1"/></joint></robot>)");
    has(noted(half,
              "f:10: note: link 'hand' has no mass, but joint 'wrist' (line 10) moves it: it weighs nothing"),
        "check_without_masses<description>");
    has(noted(half, ""), "cca::link_inertia{}};");
    has(noted(good, ""), "check_description<description>");
  }

  TEST_CASE("limits") {
    refused(with("<limit effort=\"10\" velocity=\"2\" lower=\"-1\" upper=\"1\"/>", ""),
            "f:5: error: joint 'shoulder': it needs a <limit>");
    refused(with(" effort=\"10\"", ""), "f:8: error: joint 'shoulder': <limit> needs `effort`");
    refused(with(" velocity=\"2\"", ""), "<limit> needs `velocity`");
    // Placeholders.
    for (const char* none : {"0", "-1"}) {
      const std::string header =
          noted(with("velocity=\"2\"", "velocity=\"" + std::string(none) + "\""),
                "f:8: note: joint 'shoulder': a `velocity` of " + std::string(none) +
                    " is taken as no limit, so its motor gives its torque at any speed");
      has(header, "cca::limits{cca::angle{-1, 1}, cca::torque{-10, 10}}");
      has(header, ".motor = {10, 1e9}");
      has(noted(with("effort=\"10\"", "effort=\"" + std::string(none) + "\""),
                "f:8: note: joint 'shoulder': with an `effort` of " + std::string(none) + " it has no motor"),
          "cca::torque{0, 0}");
    }
    refused(with(" lower=\"-1\" upper=\"1\"", ""), "<limit> needs `lower` and `upper`");
    refused(with("lower=\"-1\"", "lower=\"1\""), "the robot has no joint that moves");
    refused(with("lower=\"-1\"", "lower=\"2\""), "`lower` is 2 and `upper` is 1");
    has(noted(with("effort=\"10\"", "effort=\"0\""), "has no motor"), "joint_drive{}");
    has(noted(with("lower=\"-1\"", "lower=\"-6\""), "f:8: note: joint 'shoulder': its range is a whole turn"),
        "angle{-6, 1}");
    CHECK(noted(with("revolute", "continuous"), "").find("angle") == std::string::npos);
    std::string wheel = with("<limit effort=\"10\" velocity=\"2\" lower=\"-1\" upper=\"1\"/>", "");
    wheel.replace(wheel.find("revolute"), 8, "continuous");
    has(noted(wheel, "f:5: note: joint 'shoulder': without a <limit> it has no motor"),
        "cca::limits{cca::torque{0, 0}}");
    has(noted(with("lower=\"-1\"", "lower=\"0.5\""), ""), "start{0.75}");
  }

  TEST_CASE("a joint that is locked is fixed") {
    const auto locked = [](const std::string& at, const std::string& more = "") {
      std::string text = with("</robot>", hand);
      text.replace(text.find("lower=\"-1\" upper=\"1\""), 20, "lower=\"" + at + "\" upper=\"" + at + "\"");
      return text.replace(text.rfind("</joint>"), 0, more);
    };
    const std::string header = noted(
        locked("0"), "f:5: note: joint 'shoulder': `lower` and `upper` are the same, so it is fixed at 0");
    has(header, "cca::axes<axis::wrist>");
    has(header, "cca::prismatic(cca::along_x, cca::at(0, 0, 1))");
    // Turned about y by 0.5, the arm is placed elsewhere.
    const std::string turned = noted(locked("0.5"), "so it is fixed at 0.5");
    has(turned, "cca::at(0, 0, 1) * cca::turned_about(cca::along_y, 0.5");
    // What follows it is fixed, too.
    refused(locked("0.5", "<mimic joint=\"shoulder\" multiplier=\"2\"/>"), "no joint that moves");
    has(said(locked("0.5", "<mimic joint=\"shoulder\" multiplier=\"2\"/>")),
        "joint 'wrist': it follows a joint that is fixed, so it is fixed at 1");
  }

  TEST_CASE("a robot that touches itself") {
    const std::string shape = "<collision><geometry><sphere radius=\"0.1\"/></geometry></collision>",
                      flag = "touches_itself = true;", one = "fewer than two bodies have a shape";
    const std::string both = [&] {
      std::string text = with("<link name=\"base\"/>", "<link name=\"base\">" + shape + "</link>");
      return text.insert(text.find("<link name=\"arm\">") + 17, shape);
    }();
    cca_urdf::options touches;
    touches.header.touches_itself = true;
    const auto made = convert(both, touches);
    has(made.header, flag);
    has(made.header, "// By --touches-itself:");
    CHECK(made.said.empty());
    const auto without = convert(both, {});
    CHECK(without.header.find(flag) == without.header.npos);
    has(without.header, "--touches-itself was not given");
    has(said(good, touches), one);
    CHECK(convert(good, {}).header.find("touches-itself") == std::string::npos);
  }

  TEST_CASE("types of joints") {
    refused(with("revolute", "ball"), "f:5: error: joint 'shoulder': the type 'ball' is unknown");
    refused(with("revolute", "planar"), "f:5: error: joint 'shoulder': a planar joint can't be represented");
    refused(with(" type=\"revolute\"", ""), "<joint> needs `type`");
    refused(with("revolute", "fixed"), "the robot has no joint that moves");
    refused(with("<parent link=\"base\"/>", ""), "joint 'shoulder': <joint> needs a <parent>");
    // The base floats in a link without a mass; nothing else can.
    std::string floating = with("</robot>", hand);
    floating.replace(floating.find("revolute"), 8, "floating");
    has(noted(floating, ""), "floats = true");
    std::string inner = floating;
    inner.replace(inner.find("floating"), 8, "revolute");
    inner.replace(inner.find("prismatic"), 9, "floating");
    refused(inner, "joint 'wrist' floats: only the base can");
  }

  TEST_CASE("joints that follow") {
    const auto follows = [](const std::string& mimic) {
      std::string text = with("</robot>", hand);
      return text.replace(text.rfind("</joint>"), 0, mimic);
    };
    has(noted(follows("<mimic joint=\"shoulder\" multiplier=\"-2\" offset=\"0.5\"/>"),
              "follows another joint"),
        R"(.driven_by("shoulder", -2, 0.5))");
    // Its own limits are nobody's.
    for (const char* limit :
         {"", "<limit/>", "<limit effort=\"0\" velocity=\"0\" lower=\"0\" upper=\"0\"/>"}) {
      std::string text = follows("<mimic joint=\"shoulder\"/>");
      const auto at = text.rfind("<limit");
      text.replace(at, text.find("/>", at) + 2 - at, limit);
      has(noted(text, *limit ? "its own limits and its motor are left out" : ""),
          R"(.driven_by("shoulder"))");
    }
    refused(follows("<mimic joint=\"shoulder\" multiplier=\"0\"/>"), "a `multiplier` of 0");
    refused(follows("<mimic joint=\"shoulder\" offset=\"nan\"/>"),
            "joint 'wrist': <mimic> has offset=\"nan\"");
    refused(follows("<mimic joint=\"wrist\"/>"), "joint 'wrist': it follows itself");
    refused(follows("<mimic joint=\"elbow\"/>"), "joint 'wrist': there is no joint 'elbow' that moves");
    refused(follows("<mimic/>"), "<mimic> needs `joint`");
  }

  TEST_CASE("trees only") {
    refused(with("child link=\"arm\"", "child link=\"base\""), "close a loop: 'base' on 'base'");
    refused(with("child link=\"arm\"", "child link=\"leg\""),
            "f:5: error: joint 'shoulder': there is no link 'leg'");
    refused(with("<link name=\"base\"/>", "<link name=\"base\"/><link name=\"wall\"/>"),
            "no joint holds these links: link 'base' (line 2), link 'wall' (line 2)");
    refused(with("<link name=\"base\"/>", "<link name=\"base\"/><link name=\"base\"/>"),
            "link 'base' is there twice; the first is in line 2");
    const std::string again =
        "<joint name=\"again\" type=\"fixed\"><parent link=\"base\"/><child link=\"arm\"/></joint>";
    refused(with("</robot>", again + "</robot>"),
            "f:10: error: link 'arm' is the child of joint 'shoulder' (line 5) and of joint 'again'");
    refused(with("</robot>", R"(<link name="a"/><link name="b"/>
<joint name="ab" type="fixed"><parent link="a"/><child link="b"/></joint>
<joint name="ba" type="fixed"><parent link="b"/><child link="a"/></joint></robot>)"),
            "close a loop: 'a' on 'b' on 'a'");
  }

  TEST_CASE("what is left out is named") {
    const auto shape = [](const std::string& form) {
      return with("</link>", "<collision>\n<geometry>" + form + "</geometry></collision></link>");
    };
    noted(shape("<mesh filename=\"arm.stl\"/>"), "f:5: note: link 'arm': the mesh 'arm.stl' is left out");
    has(noted(shape("<cylinder radius=\"1\" length=\"2\"/>"), "the flat cylinder becomes a box"),
        R"(on_link("arm", 0, cca::robots::box(2, 2, 2))");
    std::string wheel = shape("<cylinder radius=\"1\" length=\"0.5\"/>");
    wheel.replace(wheel.find("xyz=\"0 1 0\""), 11, "xyz=\"0 0 1\"");
    has(noted(wheel, "f:5: note: link 'arm': the cylinder, a wheel, becomes a sphere of the same radius"),
        "cca::robots::sphere(1)");
    for (const char* none : {"<box size=\"0 0 0\"/>", "<box size=\"1 1 0\"/>", "<sphere radius=\"0\"/>",
                             "<cylinder radius=\"0\" length=\"1\"/>"})
      noted(shape(none), "is left out: one of its sizes is 0");
    has(noted(shape("<cylinder radius=\"0.1\" length=\"1\"/>"), "becomes a capsule"), "capsule(0.1, 0.8)");
    has(noted(shape("<box size=\"1 2 3\"/>"), ""), R"(on_link("arm", 0, cca::robots::box(1, 2, 3))");
    refused(shape("<box size=\"1 2 -3\"/>"), "each size of <box> must be above 0");
    refused(shape("<sphere/>"), "<sphere> needs `radius`");
    noted(shape("<cone radius=\"1\"/>"), "the shape <cone> is left out");
    noted(with("</robot>", "<gazebo/>\n<gazebo/></robot>"),
          "f:10: note: <gazebo> is not read; there are 2 of them");
    has(noted(with("</joint>", "<dynamics damping=\"0.5\" friction=\"2\"/></joint>"),
              "the dry friction of 2 is left"),
        ".friction = 0.5}");
    const std::string camera = with("</robot>", R"(<link name="camera"/>
<joint name="mount" type="fixed"><parent link="arm"/><child link="camera"/></joint>)" +
                                                    hand);
    cca_urdf::options strict;
    strict.strict = true;
    CHECK(convert(shape("<cone radius=\"1\"/>"), strict).header.empty());
    CHECK_FALSE(convert(camera, strict).header.empty());
    CHECK_FALSE(convert(good, strict).header.empty());
  }

  TEST_CASE("frames in the middle of a chain") {
    const std::string text = with("</robot>", R"(<link name="flange"/><link name="camera"/>
<joint name="to_flange" type="fixed"><parent link="arm"/><child link="flange"/><origin xyz="0 0 0.3"/></joint>
<joint name="to_camera" type="fixed"><parent link="flange"/><child link="camera"/><origin xyz="0.1 0 0"/></joint>)" +
                                                  hand);
    std::string gripper = text;
    gripper.replace(gripper.rfind("parent link=\"arm\""), 17, "parent link=\"flange\"");
    const auto made = convert(gripper, {});
    CHECK(made.said.empty());
    has(made.header, "struct flange : cca::frame<\"flange\"> {};");
    has(made.header,
        R"(struct flange_chain : cca::serial_chain<frame::base, frame::flange, cca::axes<axis::shoulder>> {
  static constexpr std::array joints{
      hand_chain::joints[0]};
  static constexpr cca::placement tip = cca::at(0, 0, 0.3);
};)");
    has(made.header,
        "struct camera_chain : cca::serial_chain<frame::base, frame::camera, cca::axes<axis::shoulder>>");
    has(made.header, "tip = cca::at(0, 0, 0.3) * cca::at(0.1, 0, 0);");
    has(made.header, R"(cca::part<"hand", hand_chain, cca::driven_by<"shoulder", "wrist">>)");

    cca_urdf::options ends;
    ends.ends = {"flange"};
    const std::string split = convert(gripper, ends).header;
    has(split, R"(cca::part<"flange", flange_chain, cca::driven_by<"shoulder">>)");
    has(split, "struct hand_chain : cca::serial_chain<frame::flange, frame::hand, cca::axes<axis::wrist>>");
    has(split, R"(cca::part<"camera", camera_chain>)");
    has(split, "cca::prismatic(cca::along_x, cca::placement{})");
    // The other way round: the part ends in a link from which the next joint does not hang.
    ends.ends = {"camera"};
    has(convert(gripper, ends).header, "cca::prismatic(cca::along_x, cca::at(-0.1, 0, 0))");

    const auto wrong = [&](std::vector<std::string> names, std::string_view words) {
      cca_urdf::options o;
      o.ends = std::move(names);
      CHECK(convert(gripper, o).header.empty());
      has(said(gripper, o), words);
    };
    wrong({"tool"}, "f: error: --end tool: there is no such link");
    wrong({"base"}, "f: error: --end base: no joint moves this link");
    wrong({"flange", "camera"}, "--end camera: no joint moves it against link 'flange'");
  }

  TEST_CASE("long and wide robots") {
    const auto robot = [](int links, auto&& joint) {
      std::string text = "<robot name=\"r\"><link name=\"l0\"/>";
      for (int i = 1; i < links; ++i) {
        const std::string n = std::to_string(i);
        text += "<link name=\"l" + n +
                "\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" "
                "ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>" +
                joint(i, n);
      }
      return text + "</robot>";
    };
    const auto held = [](int parent, const std::string& n, const char* type, const std::string& more = "") {
      return "<joint name=\"j" + n + "\" type=\"" + type + "\"><parent link=\"l" + std::to_string(parent) +
             "\"/><child link=\"l" + n +
             "\"/><origin xyz=\"0 0 1\"/><limit effort=\"1\" velocity=\"1\" lower=\"0\" "
             "upper=\"1\"/>" +
             more + "</joint>";
    };
    // The size of a header counts: what grows with the square of the links shows there, at any speed.
    const auto size = [&](int links, auto&& joint) {
      const auto made = convert(robot(links, joint), {});
      CHECK_FALSE(made.header.empty());
      return static_cast<double>(made.header.size()) / links;
    };
    const auto grows_with_links = [&](auto&& joint) { CHECK(size(20000, joint) < 2 * size(2000, joint)); };
    grows_with_links([&](int i, const std::string& n) { return held(i - 1, n, "revolute"); });
    grows_with_links(
        [&](int i, const std::string& n) { return held(i - 1, n, i > 1 ? "fixed" : "revolute"); });
    grows_with_links(
        [&](int i, const std::string& n) { return held(i - 1, n, i % 2 ? "revolute" : "fixed"); });
    grows_with_links([&](int, const std::string& n) { return held(0, n, "revolute"); });
    grows_with_links([&](int i, const std::string& n) {
      return held(i - 1, n, "revolute", i > 1 ? "<mimic joint=\"j" + std::to_string(i - 1) + "\"/>" : "");
    });
    // A frame after too many joints is a note.
    const auto made = convert(
        robot(400, [&](int i, const std::string& n) { return held(i - 1, n, i % 2 ? "revolute" : "fixed"); }),
        {});
    has(cca_urdf::text_of(made.said, "f"),
        "link 'l130' has no frame in the description: 65 joints of one part lead to it");
  }

  TEST_CASE("names are names of C++ and of ports") {
    has(noted(with("name=\"shoulder\"", "name=\"left.shoulder/1\""), "is the axis 'left_shoulder_1'"),
        "struct left_shoulder_1 : cca::dimension<\"left_shoulder_1\">");
    has(noted(with("name=\"shoulder\"", "name=\"torque\""), "is the axis 'torque_2'"), "struct torque_2 ");
    has(noted(with("name=\"shoulder\"", "name=\"class\""), ""), "struct class_ ");
    has(noted(with("name=\"r\"", "name=\"3 arms\""), ""), "namespace n3_arms {");
    for (const char* taken : {"std", "cca", "sim", "j1", "link", "time", "dBodyID", "size_t", "NULL"}) {
      const std::string header = noted(with("name=\"r\"", "name=\"" + std::string(taken) + "\""), "");
      has(header, "namespace " + std::string(taken) + "_robot {");
    }
    for (const char* macro : {"NULL", "NAN", "EOF", "M_PI", "INFINITY", "errno", "stdin", "linux", "cca"}) {
      const std::string name = macro;
      has(noted(with("name=\"shoulder\"", "name=\"" + name + "\""), "is the axis '" + name + "_'"),
          "struct " + name + "_ : cca::dimension<\"" + name + "_\">");
      std::string frame = with("link name=\"arm\"", "link name=\"" + name + "\"");
      frame.replace(frame.find("child link=\"arm\""), 16, "child link=\"" + name + "\"");
      has(noted(frame, ""), "struct " + name + "_ : cca::frame<\"" + name + "_\"> {};");
    }
    // Those of the same letters are counted, and no name has two underscores in a row.
    std::string twice = with("</robot>", hand);
    twice.replace(twice.find("name=\"shoulder\""), 15, "name=\"NAN\"");
    twice.replace(twice.find("name=\"wrist\""), 12, "name=\"NAN.\"");
    has(noted(twice, ""), "struct NAN_2 :");
    for (const char* node : {"synchronizer", "servos", "soft_stop", "rate"})
      noted(with("name=\"shoulder\"", "name=\"" + std::string(node) + "\""), "_2' in the description");
    // Nothing of the file gets out of a comment or a string.
    const std::string hostile = noted(with("name=\"r\"", "name=\"r&#10;#error \\&#10;\""), "");
    CHECK(hostile.find("\n#error") == std::string::npos);
    CHECK(hostile.find('\\') == std::string::npos);
    CHECK(cca_urdf::is_namespace("robots::left"));
    for (const char* wrong : {"", "a::", "::a", "a b", "int", "1a", "a__b", "a:b", "std::r", "time", "NULL"})
      CHECK_FALSE(cca_urdf::is_namespace(wrong));
  }
}
