// What cca-urdf refuses or leaves out, in words: broken files, robots that no engine can move, names.
#include <fstream>
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
    refused(good + "<robot name=\"s\"></robot>", "stands behind the <robot>");
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
    refused(with("mass value=\"2\"", "mass value=\"0\""), "link 'arm': an inertia without a mass");
    refused(with("<mass value=\"2\"/>", ""), "<inertial> needs a <mass>");
    refused(with("izz=\"0.01\"", "izz=\"-0.01\""),
            "its principal moments are -0.01, 0.02 and 0.02 kg m^2, and");
    refused(
        with("izz=\"0.01\"", "izz=\"0.05\""),
        "its principal moments are 0.02, 0.02 and 0.05 kg m^2: the largest is above the sum of the others");
    refused(with("ixy=\"0\"", "ixy=\"0.03\""), "none may be negative");
    refused(with("izz=\"0.01\"", "izz=\"0\""), "link 'arm' has an inertia that is not positive definite");
    noted(with("izz=\"0.01\"", "izz=\"0.04\""), "");  // a disc
    refused(with("<link name=\"arm\">", "<link name=\"arm\"/><link name=\"other\">"),
            "no joint holds these links");
    refused("<robot name=\"r\"><link name=\"base\"/><link name=\"arm\"/>" + good.substr(good.find("<joint")),
            "link 'arm' has no mass, but joint 'shoulder' (line 1) moves it");
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

  TEST_CASE("limits") {
    refused(with("<limit effort=\"10\" velocity=\"2\" lower=\"-1\" upper=\"1\"/>", ""),
            "f:5: error: joint 'shoulder': it needs a <limit>");
    refused(with(" effort=\"10\"", ""), "f:8: error: joint 'shoulder': <limit> needs `effort`");
    refused(with(" velocity=\"2\"", ""), "<limit> needs `velocity`");
    refused(with("velocity=\"2\"", "velocity=\"0\""), "`velocity` is 0; it must be above 0");
    refused(with("effort=\"10\"", "effort=\"-10\""), "`effort` is -10");
    refused(with(" lower=\"-1\" upper=\"1\"", ""), "<limit> needs `lower` and `upper`");
    refused(with("lower=\"-1\"", "lower=\"1\""),
            "`lower` is 1 and `upper` is 1; `lower` must be below `upper`");
    refused(with("lower=\"-1\"", "lower=\"2\""), "`lower` is 2 and `upper` is 1");
    has(noted(with("effort=\"10\"", "effort=\"0\""), "has no motor"), "joint_drive{}");
    has(noted(with("lower=\"-1\"", "lower=\"-6\""), "f:8: note: joint 'shoulder': its range is a whole turn"),
        "angle{-6, 1}");
    CHECK(noted(with("revolute", "continuous"), "").find("angle") == std::string::npos);
    has(noted(with("lower=\"-1\"", "lower=\"0.5\""), ""), "start{0.75}");
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
    noted(shape("<cylinder radius=\"1\" length=\"2\"/>"), "the cylinder is left out");
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
    noted(camera, "f:10: note: link 'camera' has no frame in the description");
    cca_urdf::options strict;
    strict.strict = true;
    CHECK(convert(camera, strict).header.empty());
    CHECK_FALSE(convert(good, strict).header.empty());
  }

  TEST_CASE("names are names of C++ and of ports") {
    has(noted(with("name=\"shoulder\"", "name=\"left.shoulder/1\""), "is the axis 'left_shoulder_1'"),
        "struct left_shoulder_1 : cca::dimension<\"left_shoulder_1\">");
    has(noted(with("name=\"shoulder\"", "name=\"torque\""), "is the axis 'torque_2'"), "struct torque_2 ");
    has(noted(with("name=\"shoulder\"", "name=\"class\""), ""), "struct class_ ");
    has(noted(with("name=\"r\"", "name=\"3 arms\""), ""), "namespace n3_arms {");
    has(noted(with("name=\"r\"", "name=\"std\""), ""), "namespace std_robot {");
    // Nothing of the file gets out of a comment or a string.
    const std::string hostile = noted(with("name=\"r\"", "name=\"r&#10;#error \\&#10;\""), "");
    CHECK(hostile.find("\n#error") == std::string::npos);
    CHECK(hostile.find('\\') == std::string::npos);
    CHECK(cca_urdf::is_namespace("robots::left"));
    for (const char* wrong : {"", "a::", "::a", "a b", "int", "1a", "a__b", "a:b"})
      CHECK_FALSE(cca_urdf::is_namespace(wrong));
  }
}
