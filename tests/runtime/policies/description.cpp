// What a program that trains is told of a policy: by its contract, or by the robot's types alone.
#include <string>

#include <doctest/doctest.h>

#include <cca/mapping/imported/policy_description.hpp>
#include <cca/python/stand_in.hpp>

#include "walker.hpp"

#include "written/walk.hpp"

namespace {

using namespace policies;

struct learner {
  using inputs =
      cca::policy_inputs<cca::in<"attitude", walker::attitude>, cca::in<"joint_pos", walker::angles>>;
  using action_space = walker::targets;
};
struct small : cca::policy<learner::inputs, cca::hidden_layers<4>, cca::rectifier, walker::targets> {};
struct stands_in : cca::python::stand_in<small> {};

}  // namespace

TEST_CASE("an imported policy is described by its contract, with units and limits of the robot") {
  const auto d = cca::describe_policy<walker::walking<walk::contract>>();
  CHECK(d.name == "walk");
  CHECK(d.rate == 50);
  CHECK(d.joints == std::vector<std::string>{"left_hip", "left_knee_bend", "right_hip", "right_knee"});
  CHECK(d.stiffness == std::vector<double>{25, 25, 25, 25});
  CHECK(d.history == 3);
  CHECK(d.layout == "by_term");
  CHECK(d.inputs == 63);
  CHECK(d.outputs == 4);
  REQUIRE(d.terms.size() == 6);
  CHECK(d.terms[0].is == "angular_velocity<trunk>");
  CHECK(d.terms[0].numbers[0].scale == 0.2);
  CHECK(d.terms[0].clip.lower == -100);
  CHECK(d.terms[3].name == "joint_pos_rel");
  CHECK(d.terms[3].numbers[1].name == "left_knee_bend");
  CHECK(d.terms[3].numbers[1].sign == -1);
  CHECK(d.terms[3].numbers[1].rest == 0.8);
  CHECK(d.terms[3].numbers[1].limits.upper == 2.5);
  CHECK(d.terms[3].numbers[1].unit == "rad");
  CHECK(d.action.numbers[0].scale == 0.25);
  CHECK(d.action.clip.upper == 3);
}

TEST_CASE("of types alone names, order, frames, units, limits and the rate are known") {
  for (const auto& d : {cca::describe_policy<learner>("l"), cca::describe_policy<small>("l"),
                        cca::describe_policy<stands_in>("l")}) {
    CHECK(d.name == "l");
    CHECK(d.rate == 50);
    CHECK(d.joints == std::vector<std::string>{"right_knee", "left_knee_bend", "left_hip", "right_hip"});
    CHECK(d.stiffness.empty());
    CHECK(d.history == 1);
    REQUIRE(d.terms.size() == 2);
    CHECK(d.terms[0].is == "orientation<world>");
    CHECK(d.terms[0].numbers[3].name == "qw");
    CHECK(d.terms[1].numbers[0].limits.lower == -2.5);
    CHECK(d.inputs == 8);
    CHECK(d.outputs == 4);
    const std::string json = cca::json_of(d);
    CHECK(json.find("\"joints\": [\"right_knee\", \"left_knee_bend\", \"left_hip\", \"right_hip\"]") !=
          std::string::npos);
    CHECK(json.find("\"limits\": [[-2.5, 0], [0, 2.5], [-1, 1], [-1, 1]]") != std::string::npos);
    CHECK(json.find("inf") == std::string::npos);
  }
}
