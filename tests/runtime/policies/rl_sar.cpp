// Configurations in the layout of rl_sar: one mapping below the name of robot and training, lists of numbers
// for each joint, a history as indices into the past.
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include <cca/base/file.hpp>

#include "policy/writing.hpp"

namespace {

const std::string networks = CCA_POLICIES "/networks/";

struct files {
  std::string configuration = R"(robot/training:
  model_name: "policy.onnx"
  observations: ["ang_vel", "gravity_vec", "commands", "dof_pos", "dof_vel", "actions"]
  observations_history: []  # 0 is the latest observation
  observations_history_priority: "time"
  clip_obs: 100.0
  clip_actions_lower: [-90.0, -90.0,
                       -90.0, -90.0]
  clip_actions_upper: [90.0, 90.0, 90.0, 90.0]
  rl_kp: [20.0, 25.0, 20.0, 25.0]
  rl_kd: [0.5, 0.75, 0.5, 0.75]
  action_scale: [0.125, 0.25, 0.125, 0.25]
  lin_vel_scale: 2.0
  ang_vel_scale: 0.25
  dof_pos_scale: 1.0
  dof_vel_scale: 0.05
  commands_scale: [2.0, 0.5]
  default_dof_pos: [0.1, -0.8, -0.1, -0.8]
  joint_names: ["left_hip", "left_knee", "right_hip", "right_knee"]
  joint_mapping: [0, 1, 2, 3]
  dt: 0.005
  decimation: 4
)";
  std::string map = R"(
[history]
order = "oldest_first"
[observation.ang_vel]
is = "angular_velocity<trunk>"
[observation.gravity_vec]
is = "cartesian_position<trunk>"
[observation.commands]
is = "number"
numbers = ["forward", "turning"]
[observation.dof_pos]
is = "joint_angles"
relative_to = "default"
[observation.dof_vel]
is = "joint_velocities"
[observation.actions]
is = "last_action"
[action]
is = "joint_angles"
relative_to = "default"
last_action = "raw"
[network]
normaliser = "none"
)";

  void put(std::string files::* in, const std::string& old, const std::string& now) {
    const auto at = (this->*in).find(old);
    REQUIRE_MESSAGE(at != std::string::npos, old);
    (this->*in).replace(at, old.size(), now);
  }
};

struct result {
  cca_policy::imported policy;
  std::string said;  // the first complaint
};
result of(const files& f) {
  cca_policy::complaints wrong;
  result r;
  try {
    r.policy = cca_policy::import_policy({"tangent.onnx", cca::detail::read_file(networks + "tangent.onnx")},
                                         {"config.yaml", f.configuration}, {"map.toml", f.map}, wrong);
    if (!wrong.all().empty()) r.said = wrong.all().front();
  } catch (const cca::refused& e) { r.said = e.what(); }
  return r;
}
using lines = std::vector<double>;

}  // namespace

TEST_SUITE("rl_sar") {
  TEST_CASE("a configuration is read, each number to its place") {
    const result r = of({});
    REQUIRE(r.said == "");
    const cca_policy::contract& c = r.policy.terms;
    CHECK(c.rate == doctest::Approx(50));
    CHECK(c.history == 1);
    CHECK(c.joints == std::vector<std::string>{"left_hip", "left_knee", "right_hip", "right_knee"});
    CHECK(c.stiffness == lines{20, 25, 20, 25});
    CHECK(c.damping == lines{0.5, 0.75, 0.5, 0.75});
    REQUIRE(c.terms.size() == 6);
    const auto scale = [&](std::size_t term, std::size_t i) { return c.terms[term].numbers[i].scale; };
    CHECK(c.terms[0].name == "ang_vel");
    CHECK(scale(0, 2) == 0.25);
    CHECK(scale(1, 0) == 1);
    CHECK(scale(2, 0) == 2);
    CHECK(scale(2, 1) == 0.5);
    CHECK(scale(3, 3) == 1);
    CHECK(c.terms[3].numbers[1].rest == -0.8);
    CHECK(scale(4, 1) == 0.05);
    CHECK(scale(5, 0) == 1);
    for (const auto& t : c.terms) {  // clip_obs is a clip of what was scaled
      CHECK(t.clip.lower == -100);
      CHECK(t.clip.upper == 100);
      CHECK(t.clips_scaled);
    }
    CHECK(c.action.numbers[0].scale == 0.125);
    CHECK(c.action.numbers[3].scale == 0.25);
    CHECK(c.action.numbers[2].rest == -0.1);
    CHECK(c.action.clip.lower == -90);
    CHECK(c.action.clip.upper == 90);
  }

  TEST_CASE("without the name above the keys it is the same") {
    files f;
    f.configuration.erase(0, f.configuration.find('\n') + 1);
    const result r = of(f), named = of({});
    REQUIRE(r.said == "");
    CHECK(cca_policy::contract_lines(r.policy) == cca_policy::contract_lines(named.policy));
  }

  TEST_CASE("a history is as many indices, in the order in which the network sees them") {
    // The network has one observation, so the dimensions are refused after the history was read.
    const auto history = [](const std::string& past, const std::string& priority) {
      files f;
      f.put(&files::configuration, "observations_history: []", "observations_history: " + past);
      f.put(&files::configuration, "\"time\"", priority);
      f.put(&files::map, "order = \"oldest_first\"", "start = \"zero\"");
      return of(f);
    };
    const result newest = history("[0, 1, 2]", "\"time\"");
    CHECK(newest.policy.terms.history == 3);
    CHECK(newest.policy.terms.order == "newest_first");
    CHECK(newest.policy.terms.layout == "by_time");
    CHECK(newest.said.find("times 3 of history") != std::string::npos);
    const result oldest = history("[4, 3, 2, 1, 0]", "\"term\"");
    CHECK(oldest.policy.terms.history == 5);
    CHECK(oldest.policy.terms.order == "oldest_first");
    CHECK(oldest.policy.terms.layout == "by_term");
    CHECK(history("[0, 2, 4]", "\"time\"").said ==
          "config.yaml:4: observations_history has gaps, which is not possible here");
    CHECK(history("[1, 0]", "\"both\"").said == "config.yaml:5: expected time or term, got `both`");
  }

  TEST_CASE("what it does not say is asked, what differs is refused") {
    const auto said = [](std::string files::* in, const std::string& old, const std::string& now) {
      files f;
      f.put(in, old, now);
      return of(f).said;
    };
    const auto in = &files::configuration;
    CHECK(said(in, "  dt: 0.005\n", "") ==
          "no file says `rate`: the policy's steps a second; write it in the map");
    CHECK(said(in, "joint_mapping: [0, 1, 2, 3]", "joint_mapping: [2, 3, 0, 1]") ==
          "no file says `joints`: the names of the joints in the policy's order; write it in the map");
    CHECK(said(in, "ang_vel_scale: 0.25", "ang_vel_scale: fast") ==
          "config.yaml:14: expected a number, got `fast`");
    CHECK(said(in, "[90.0, 90.0, 90.0, 90.0]", "[90.0, 80.0, 90.0, 90.0]") ==
          "config.yaml:9: clip_actions differs from joint to joint, which is not possible here");
    // A policy that does not observe its last action has no scale of it.
    CHECK(said(in, ", \"actions\"]", "]")
              .starts_with("map.toml:17: `observation.actions.is`: the policy has no observation"));
    CHECK(said(in, "rl_kp: [20.0", "rl_kp: [0.0") ==
          "`stiffness` is zero or less: left_hip 0 N m/rad: it was baked in, and there the robot would hang");
    CHECK(said(in, "rl_kd: [0.5, 0.75, 0.5, 0.75]", "rl_kd: [0.5, 0.75, 0.5]")
              .find("`damping` has 3 numbers, expected 4") != std::string::npos);
    CHECK(said(in, "  observations: [", "  seen: [") ==
          "config.yaml: it has no `observations`: expected a deploy.yaml or a configuration of rl_sar");
    CHECK(said(&files::map, "[observation.ang_vel]\n", "[observation.ang_vel]\nscale = 0.5\n")
              .starts_with("`observation.ang_vel.scale` is said twice, and differs: number 0 is 0.25 and 0.5 "
                           "(config.yaml:14 and "));
  }
}
