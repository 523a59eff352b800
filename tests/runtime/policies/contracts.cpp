// 40 contracts, each broken in one way: the importer, the compiler or the load refuses each with a sentence
// that names it, and the contract as it was is accepted. docs/policies.md shows them as a table.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include <cca/base/file.hpp>

#include "files_of_walk.hpp"
#include "walker.hpp"

#include "written/walk.hpp"

namespace {

using namespace policies;

// What the compiler says of the contract of walk/ and these spaces; empty: it accepts them.
template <class Inputs, class To>
std::string said_by_compiler() {
  using check = cca::detail::contract_check<walk::contract, Inputs, To>;
  static constexpr cca::detail::text said = [] {
    cca::detail::text m;
    check::tell(m);
    return m;
  }();
  static_assert((said.size == 0) == check::holds);
  return std::string(said.view());
}

// What the load of these weights says.
std::string said_on_load(std::string text) {
  static const std::string file = "weights.policy";
  auto into = std::make_unique<walker::walking<walk::contract>::weight_array>();
  try {
    cca::detail::read_policy_weights<float>(text, file, walk::contract::name, walk::contract::lines, *into);
    return "";
  } catch (const cca::refused& e) { return e.what(); }
}
std::string weights_of(const files& f) {
  cca_policy::complaints wrong;
  const auto p = imported(f, wrong);
  REQUIRE(wrong.all().empty());
  return cca_policy::weights_file(p);
}

struct row {
  std::string broken, by, said;
};
std::vector<row> rows;

void by_importer(const std::string& what, const std::function<void(files&)>& breaks) {
  files f;
  CHECK_MESSAGE(said_of(f).empty(), what);
  breaks(f);
  rows.push_back({what, "importer", said_of(f)});
}
template <class Inputs, class To = walker::targets>
void by_compiler(const std::string& what) {
  CHECK((said_by_compiler<walker::observations, walker::targets>().empty()));
  rows.push_back({what, "compiler", said_by_compiler<Inputs, To>()});
}
void on_load(const std::string& what, const std::string& text) {
  CHECK(said_on_load(weights_of({})).empty());
  rows.push_back({what, "load", said_on_load(text)});
}

// Other spaces than the robot's.
struct imu : cca::frame<"imu"> {};
struct tail : cca::dimension<"tail"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}};
};
namespace backwards {
struct left_knee_bend : cca::dimension<"left_knee_bend"> {
  static constexpr auto limits = cca::limits{cca::angle{-2.5, 0}};
};
}  // namespace backwards
struct gyro_of_imu : cca::space<cca::robots::angular_velocity<imu>, xyz> {};
struct three_angles : cca::space<cca::joint_angles, cca::axes<left_hip, right_hip, right_knee>> {};
struct five_angles : cca::space<cca::joint_angles,
                                cca::axes<left_hip, walker::left_knee_bend, right_hip, right_knee, tail>> {};
struct turned_angles
    : cca::space<cca::joint_angles, cca::axes<left_hip, backwards::left_knee_bend, right_hip, right_knee>> {};
struct fast_targets : cca::space<cca::joint_angles, walker::joints, cca::rate<200>> {};

template <class Gyro, class Angles, class Velocities>
using with = cca::policy_inputs<cca::in<"joint_vel_rel", Velocities>,
                                cca::in<"base_ang_vel", Gyro>,
                                cca::in<"attitude", walker::attitude>,
                                cca::in<"joint_pos_rel", Angles>,
                                cca::in<"velocity_commands", command>>;

std::string ones() {
  std::string all = "[1";
  for (int i = 1; i < 63; ++i) all += ", 1";
  return all + "]";
}

const std::string joints = "left_hip,left_knee,right_hip,right_knee";

void break_all() {
  by_importer("joints in another order",
              [](files& f) { put_in_place(f.onnx, joints, "right_hip,right_knee,left_hip,left_knee"); });
  by_importer("an observation before another one", [](files& f) {
    put_in_place(f.onnx, "joint_pos_rel,joint_vel_rel", "joint_vel_rel,joint_pos_rel");
  });
  by_importer("another default pose", [](files& f) { put_in_place(f.onnx, "0.100,-0.800", "0.300,-0.800"); });
  by_importer("a default pose in degrees", [](files& f) {
    put(f.deploy, "default_joint_pos: [0.1, -0.8, -0.1, -0.8]",
        "default_joint_pos: [5.73, -45.8, -5.73, -45.8]");
    put_in_place(f.onnx, "default_joint_pos", "default_joint_xyz");
  });
  by_importer("gains of zero, baked in", [](files& f) {
    put(f.deploy, "stiffness: [25.0", "stiffness: [0.0");
    put_in_place(f.onnx, "joint_stiffness", "joint_xyzxyzxyz");
  });
  by_importer("other gains", [](files& f) { put_in_place(f.onnx, "25.000,25.000", "40.000,25.000"); });
  by_importer("another scale of the action",
              [](files& f) { put_in_place(f.onnx, "0.250,0.250", "0.500,0.500"); });
  by_importer("another offset of the action",
              [](files& f) { put(f.deploy, "offset: [0.1", "offset: [0.0"); });
  by_importer("another rate", [](files& f) { f.map = "rate = 100\n" + f.map; });
  by_importer("another scale of an observation",
              [](files& f) { put(f.map, "clips = ", "scale = 0.25\nclips = "); });
  by_importer("degrees for rad", [](files& f) {
    put(f.deploy, "scale: [1.0, 1.0, 1.0, 1.0]\n    history_length: 3\n  joint_vel_rel",
        "scale: [57.3, 57.3, 57.3, 57.3]\n    history_length: 3\n  joint_vel_rel");
  });
  by_importer("an observation that nobody scaled", [](files& f) {
    put(f.deploy, "clip: [-100, 100]\n    scale: [0.2, 0.2, 0.2]", "clip: [-100, 100]\n    scale: null");
  });
  by_importer("another clip", [](files& f) { put(f.map, "clips = ", "clip = [-10, 10]\nclips = "); });
  by_importer("a clip before or after the scale",
              [](files& f) { put(f.map, "clips = \"before_scale\"", ""); });
  by_importer("another length of the history",
              [](files& f) { put(f.map, "[history]", "[history]\nlength = 5"); });
  by_importer("a history of one term only",
              [](files& f) { put(f.deploy, "history_length: 3", "history_length: 1"); });
  by_importer("a history by time or by term", [](files& f) { put(f.map, "layout = \"by_term\"", ""); });
  by_importer("a history from the oldest or from the newest",
              [](files& f) { put(f.map, "order = \"oldest_first\"", "order = \"oldest\""); });
  by_importer("a history that begins with zeros or copies",
              [](files& f) { put(f.map, "start = \"repeated\"", ""); });
  by_importer("a quaternion of unknown order", [](files& f) { put(f.map, "quaternion = \"wxyz\"", ""); });
  by_importer("a frame that nobody names",
              [](files& f) { put(f.map, "angular_velocity<trunk>", "angular_velocity"); });
  by_importer("angles relative to zero or to the default pose", [](files& f) {
    put(f.map, "is = \"joint_angles\"\nrelative_to = \"default\"", "is = \"joint_angles\"");
  });
  by_importer("a joint that is missing",
              [](files& f) { put(f.deploy, "joint_ids_map: [2, 3, 0, 1]", "joint_ids_map: [2, 3, 0]"); });
  by_importer("a joint too many", [](files& f) {
    put(f.deploy, "joint_ids_map: [2, 3, 0, 1]", "joint_ids_map: [2, 3, 0, 1, 4]");
  });
  by_importer("a sign that is none", [](files& f) { put(f.map, "sign = -1", "sign = 0"); });
  by_importer("a normaliser that is missing in the file", [](files& f) {
    put_in_place(f.onnx, "Sub", "Abs");
    put_in_place(f.onnx, "Div", "Abs");
  });
  by_importer("a normaliser twice", [](files& f) {
    put(f.map, "normaliser = \"inside\"",
        "normaliser = \"outside\"\nmean = " + ones() + "\ndeviation = " + ones());
  });
  by_importer("the last action raw or clipped", [](files& f) { put(f.map, "last_action = \"raw\"", ""); });
  by_importer("a network of other dimensions", [](files& f) {
    put(f.map, "numbers = [\"forward\", \"turning\"]", "numbers = [\"forward\"]");
    put(f.deploy, "scale: [1.0, 1.0]", "scale: [1.0]");
  });
  by_importer("an operator that is not known", [](files& f) { put_in_place(f.onnx, "Elu", "Erf"); });
  by_importer("an opset that is not known", [](files& f) {
    put_in_place(f.onnx, std::string("\x42\x04\x0a\x00\x10\x0b", 6),
                 std::string("\x42\x04\x0a\x00\x10\x63", 6));
  });
  by_importer("a file that was cut off", [](files& f) { f.onnx.resize(f.onnx.size() / 2); });
  by_importer("a key of the map that does not exist",
              [](files& f) { put(f.map, "quaternion", "quarternion"); });

  by_compiler<with<gyro_of_imu, walker::angles, walker::velocities>>("another frame");
  by_compiler<with<gyro, walker::velocities, walker::velocities>>("velocities for angles");
  by_compiler<with<gyro, three_angles, walker::velocities>>("a robot without a joint of the policy");
  by_compiler<with<gyro, five_angles, walker::velocities>>("a robot with a joint more");
  by_compiler<with<gyro, turned_angles, walker::velocities>>("a joint that counts the other way round");
  by_compiler<walker::observations, fast_targets>("commands at another rate");

  on_load("wxyz for xyzw, in one of two exports", [] {
    files f;
    put(f.map, "wxyz", "xyzw");
    return weights_of(f);
  }());
  on_load("weights of another training", [] {
    files f;  // raw data of a tensor of 16 x 32: field 9, its length in two bytes, numbers
    const auto at = f.onnx.find(std::string("\x4a\x80\x10", 3));
    REQUIRE(at != std::string::npos);
    f.onnx[at + 4] = static_cast<char>(f.onnx[at + 4] ^ 1);
    return weights_of(f);
  }());
  on_load("weights that were damaged", [] {
    std::string text = weights_of({});
    text[text.size() / 2] = text[text.size() / 2] == '1' ? '2' : '1';
    return text;
  }());
}

}  // namespace

TEST_CASE("40 contracts broken in one way each are refused, and docs/policies.md shows what is said") {
  rows.clear();
  break_all();
  CHECK(rows.size() >= 40);
  const std::string page = cca::detail::read_file(CCA_DOCS "/policies.md");
  for (const row& r : rows) {
    CHECK_MESSAGE(!r.said.empty(), r.broken);
    std::string said;
    for (const char c : r.said) said += c == '|' ? "\\|" : std::string(1, c);
    const std::string line = "| " + r.broken + " | " + r.by + " | " + said + " |\n";
    CHECK_MESSAGE(page.find(line) != std::string::npos, line);
  }
}

TEST_CASE("docs/policies.md lists each operator and each key of a map") {
  const std::string page = cca::detail::read_file(CCA_DOCS "/policies.md");
  for (const auto& one : cca_policy::all_operators())
    CHECK_MESSAGE(page.find("`" + one.first + "`") != std::string::npos, one.first);
  for (const std::string_view key : cca_policy::map_keys) {
    std::string named(key);
    if (const auto star = named.find('*'); star != std::string::npos) named.replace(star, 1, "NAME");
    CHECK_MESSAGE(page.find("`" + named + "`") != std::string::npos, named);
  }
}
