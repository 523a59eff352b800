// What cca-policy reads beside contracts that are broken (contracts.cpp): actions, weights in another file,
// and how it says what is wrong and what it wrote.
#include <functional>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "files_of_walk.hpp"

namespace {

using namespace policies;

const std::string none = "joint_ids: null";
const std::string action = R"(  JointPositionAction:
    clip: null
    joint_names: [.*]
    scale: [0.25, 0.25, 0.25, 0.25]
    offset: [0.1, -0.8, -0.1, -0.8]
    joint_ids: null
)";

// walk/ with other actions than the one that it has.
files with_actions(const std::string& actions) {
  files f;
  put(f.deploy, action, actions);
  return f;
}
std::string action_of(const std::string& name,
                      const std::string& ids,
                      const std::string& scale,
                      const std::string& offset) {
  return "  " + name + ":\n    clip: null\n    scale: " + scale + "\n    offset: " + offset +
         "\n    joint_ids: " + ids + "\n";
}

// A network whose weights lie beside it, and what the importer makes of other files there.
const std::string networks = CCA_POLICIES "/networks/";
std::string said_beside(
    const std::string& data, const std::function<void(std::string&)>& breaks = [](std::string&) {}) {
  std::string onnx = cca::detail::read_file(networks + "beside.onnx");
  breaks(onnx);
  try {
    cca_policy::complaints wrong;
    (void)cca_policy::import_policy({"beside.onnx", onnx}, {},
                                    {"robot.toml", cca::detail::read_file(networks + "robot.toml")}, wrong,
                                    [&](const std::string&) { return data; });
    return wrong.all().empty() ? "" : wrong.all().front();
  } catch (const cca::refused& e) { return e.what(); }
}

}  // namespace

TEST_CASE("deploy.yaml may write all joints as nothing, as Python's slice(None), or one by one") {
  for (const std::string all :
       {"joint_ids: !!python/object/apply:builtins.slice [null, null, null]", "joint_ids: [0, 1, 2, 3]"}) {
    files f;
    put(f.deploy, none, all);
    CHECK_MESSAGE(said_of(f) == "", all);
  }
  const std::string not_numbers =
      "deploy.yaml:18: `joint_ids` of the action `JointPositionAction`: expected nothing for all joints, or "
      "their numbers in joint_ids_map";
  const auto said_with = [](const std::string& ids) {
    files f;
    put(f.deploy, none, "joint_ids: " + ids);
    return said_of(f);
  };
  for (const std::string some : {"!!python/object/apply:builtins.slice [null, 2, null]", "[null, null, null]",
                                 "[0, 1, 2, x]", "4", "[]"})
    CHECK_MESSAGE(said_with(some) == not_numbers, some);
  CHECK(said_with("[0, 1, 2, 4]") == "deploy.yaml:13: an action moves joint 4, and the joints are 0 to 3");
  CHECK(said_with("[0, 1, 2, 1.5]") ==
        "deploy.yaml:13: an action moves joint 1.5, and the joints are 0 to 3");
  CHECK(said_with("[0, 1, 2, 2]") == "deploy.yaml:13: `joint_ids` has right_hip twice");
  CHECK(said_with("[0, 1, 2]") ==
        "deploy.yaml:16: the action `JointPositionAction` moves 3 joints, and this has 4 numbers");
}

TEST_CASE("two actions stand one after the other, each with joints of its own") {
  cca_policy::complaints wrong;
  const files f = with_actions(action_of("RightAction", "[2, 3]", "0.5", "[-0.1, -0.8]") +
                               action_of("LeftPositionAction", "[1, 0]", "[0.2, 0.3]", "[-0.8, 0.1]"));
  files g = f;
  put_in_place(g.onnx, "action_scale", "action_other");
  put_in_place(g.onnx, "joint_stiffness", "joint_xyzxyzxyz");
  put(g.deploy, "stiffness: [25.0, 25.0, 25.0, 25.0, 0.0]", "stiffness: [30.0, 40.0, 10.0, 20.0, 0.0]");
  const auto p = imported(g, wrong);
  for (const std::string& one : wrong.all()) MESSAGE(one);
  REQUIRE(wrong.all().empty());
  std::string order;
  for (const auto& n : p.terms.action.numbers)
    order += n.name + " " + cca_policy::text_of(n.rest) + " " + cca_policy::text_of(n.scale) + "; ";
  CHECK(order == "right_hip -0.1 0.5; right_knee -0.8 0.5; left_knee_bend 0.8 0.2; left_hip 0.1 0.3; ");
  std::string seen;
  for (const auto& n : p.terms.terms.back().numbers) seen += n.name + "; ";  // the last action
  CHECK(seen == "right_hip; right_knee; left_knee; left_hip; ");
  const std::string written = cca_policy::header(p).text();
  CHECK(
      written.find("{\"right_hip\", 30, 0.5},\n      {\"right_knee\", 40, 0.5},\n      {\"left_knee_bend\", "
                   "20, 0.5},\n      {\"left_hip\", 10, 0.5}") != std::string::npos);
}

TEST_CASE("two actions that can't stand one after the other are refused by their names") {
  const std::string half = "[0.25, 0.25]", left = "[0.1, -0.8]", right = "[-0.1, -0.8]";
  const auto said = [](const std::string& actions) { return said_of(with_actions(actions)); };
  CHECK(
      said(action_of("LeftAction", "[0, 1]", half, left) + action_of("RightAction", "[1, 2]", half, right)) ==
      "deploy.yaml:18: the actions `LeftAction` and `RightAction` both move joint 1: actions stand one after "
      "the other, each with joints of its own");
  CHECK(
      said(action + action_of("RightAction", "[2, 3]", half, right)) ==
      "deploy.yaml:19: the actions `JointPositionAction` and `RightAction` both move joint 2: actions stand "
      "one after the other, each with joints of its own");
  CHECK(
      said(action_of("JointPositionAction", "[0, 1]", half, left) +
           action_of("JointVelocityAction", "[2, 3]", half, right)) ==
      "deploy.yaml:18: the actions `JointPositionAction` and `JointVelocityAction` command different things; "
      "here all joints get targets of one kind");
  CHECK(said(action_of("LeftAction", "[0, 1]", half, left)) ==
        "deploy.yaml:13: no action moves right_hip, right_knee, and here all joints are moved");
  CHECK(said(action_of("LeftAction", "[0, 1]", half, left) +
             action_of("RightAction", "[2, 3]", "null", right)) ==
        "deploy.yaml:15: not all actions have a `scale`, and some have one");
  files f = with_actions(action + action_of("RightAction", "[2, 3]", half, right));
  put(f.deploy, "joint_ids_map: [2, 3, 0, 1]\n", "");
  CHECK(said_of(f) ==
        "deploy.yaml:12: the action `JointPositionAction` moves all joints, and there is another "
        "action: each needs joints of its own");
}

TEST_CASE("weights beside the model are read within the bounds of their file") {
  const std::string data = cca::detail::read_file(networks + "beside.onnx.data");
  CHECK(said_beside(data) == "");
  CHECK(said_beside(data.substr(0, data.size() - 4))
            .ends_with("lies in `beside.onnx.data` up to byte 35088, and the file has 35084: it is damaged, "
                       "or of another export"));
  CHECK(said_beside("").find("up to byte ") != std::string::npos);
  const auto elsewhere = [&](const std::string& location) {
    return said_beside(data, [&](std::string& onnx) {
      REQUIRE(location.size() == std::string("beside.onnx.data").size());
      for (std::size_t at = 0; (at = onnx.find("beside.onnx.data")) != std::string::npos;)
        onnx.replace(at, location.size(), location);
    });
  };
  CHECK(elsewhere("weights/all.data") == "");
  for (const std::string outside :
       {"../../weights.wb", "weights/../../al", "/etc/weights.bin", "weights\\all.data", "a/weights/dat/.."})
    CHECK_MESSAGE(elsewhere(outside) == "beside.onnx: the tensor `t1` lies in `" + outside +
                                            "`: expected a file in the folder of the model or below it",
                  outside);
  const auto with = [&](const std::string& old, const std::string& now) {
    return said_beside(data, [&](std::string& onnx) { put_in_place(onnx, old, now); });
  };
  CHECK(with("5120", "512x") ==
        "beside.onnx: damaged: the tensor `t1` lies in `beside.onnx.data` at `512x`, which is no number of "
        "bytes");
  CHECK(with("5120", "5124") ==
        "beside.onnx: damaged: the tensor `t1` has 1281 numbers, which is not what its shape says");
  CHECK(with("5120", "-120").find("at `-120`, which is no number of bytes") != std::string::npos);
  CHECK(with("5120", "9999").find("ends within a number") != std::string::npos);
  CHECK(with("35072", "90000") ==
        "beside.onnx: the tensor `t22` lies in `beside.onnx.data` up to byte 90000, and the file has 35088: "
        "it is "
        "damaged, or of another export");
  // Only the text is known.
  try {
    (void)cca_policy::read_onnx(cca::detail::read_file(networks + "beside.onnx"));
    FAIL("it was read");
  } catch (const cca::refused& e) {
    CHECK(std::string(e.what()) ==
          "the tensor `t1` lies in `beside.onnx.data`, and only this file is known here: write "
          "one with the weights inside, in Python by onnx.save(onnx.load(FILE), NEW_FILE)");
  }
}

TEST_CASE("gains that can't be are one complaint with all joints") {
  files f;
  put(f.deploy, "stiffness: [25.0, 25.0, 25.0, 25.0", "stiffness: [0.0, 0.0, 25.0, -1.0");
  put(f.deploy, "damping: [0.5, 0.5", "damping: [0.5, -0.5");
  put_in_place(f.onnx, "joint_stiffness", "joint_xyzxyzxyz");
  put_in_place(f.onnx, "joint_damping", "joint_xyzxyzx");
  cca_policy::complaints wrong;
  (void)imported(f, wrong);
  CHECK(wrong.all() ==
        std::vector<std::string>{
            "`stiffness` is zero or less: left_knee -1, right_hip 0, right_knee 0 N m/rad: it was baked in, "
            "and "
            "there the robot would hang",
            "`damping` is below zero: right_knee -0.5 N m s/rad: there the robot would swing itself up"});
}

TEST_CASE("an empty text in the map is named") {
  files f;
  f.map = "name = \"\"\n" + f.map;
  CHECK(said_of(f) == "map.toml:1: `name` is an empty text: write one, or leave out the key");
  files g;
  put(g.map, "numbers = [\"forward\", \"turning\"]", "numbers = [\"forward\", \"\"]");
  CHECK(said_of(g).ends_with(
      "`observation.velocity_commands.numbers` is an empty text: write one, or leave out the key"));
}

TEST_CASE("a key that stands below a table of the map is told where it belongs") {
  files f;
  f.map += "\noldest = 0.1\n";
  CHECK(said_of(f).ends_with(".oldest`; `oldest` stands above the first [...] of the file"));
}

TEST_CASE("what was imported is said in three lines") {
  cca_policy::complaints wrong;
  CHECK(cca_policy::summary(imported({}, wrong)) ==
        "the policy `walk` at 50 Hz, from walk.onnx, deploy.yaml, map.toml\n"
        "  commands 4 joints: left_hip, left_knee, right_hip, right_knee\n"
        "  observes 21 numbers, 3 times: base_ang_vel 3, attitude 4, velocity_commands 2, joint_pos_rel 4, "
        "joint_vel_rel 4, last_action 4\n");
}

TEST_CASE("a list that two terms share complains once") {
  files f;
  put(f.deploy, "default_joint_pos: [0.1, -0.8, -0.1, -0.8]", "default_joint_pos: [0.1, -0.8, -0.1]");
  put_in_place(f.onnx, "default_joint_pos", "default_joint_rot");
  cca_policy::complaints wrong;
  (void)imported(f, wrong);
  int times = 0;
  for (const std::string& one : wrong.all())
    times += one == "deploy.yaml:5: `default_positions` has 3 numbers, expected 4";
  CHECK(times == 1);
}

TEST_CASE("joints without names are one complaint, not one for each list of numbers") {
  files f;
  put_in_place(f.onnx, "joint_names", "joint_other");
  put(f.map, "sdk_joints = ", "# ");
  cca_policy::complaints wrong;
  (void)imported(f, wrong);
  REQUIRE(wrong.all().size() == 1);
  CHECK(wrong.all().front() ==
        "no file says `joints`: the names of the joints in the policy's order, or `sdk_joints` in the order "
        "of the motors, for joint_ids_map; write it in the map");
}
