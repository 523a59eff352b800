// The kinds of uncertainty that tools/uncertainty tries: the readings that each of them changes on an Oncilla
// that steps on the spot, whose targets read no sensor. A kind that changed nothing would be borne by all.
#include <doctest/doctest.h>

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <cca/cca.hpp>
#include <cca/sim/oncilla.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>
#include <cca/sim/uncertain/uncertain_robot.hpp>

#include "../../../tools/uncertainty/kinds.hpp"

namespace {

namespace sim = cca::sim;
namespace oncilla = cca::robots::oncilla;

struct stepping {
  static auto process(cca::beat now) -> cca::out<"angles", oncilla::leg_angles> {
    const double way = 0.3 * cca::math::sin(2e-8 * static_cast<double>(now.time()));
    oncilla::leg_angles::vector_type q;
    q << 0.7, 0.7, 0.7, 0.7, 1.5, 1.5, 1.5, 1.5;
    for (Eigen::Index i = 0; i < q.size(); ++i) q[i] += i % 2 ? way : -way;
    return q;
  }
};
template <class World>
struct stepped : cca::graph<cca::rate<1000>,
                            cca::node<"targets", stepping>,
                            cca::node<"limits", cca::limiter<oncilla::leg_angles>>,
                            cca::node<"robot", sim::robot<oncilla::as_built, sim::uncertain<World>>>,
                            cca::wire<"targets.angles", "limits.command">,
                            cca::wire<"targets.angles", "limits.measured">,
                            cca::wire<"limits.safe", "robot.command">,
                            cca::observe<"robot.angles">,
                            cca::observe<"robot.velocities">,
                            cca::observe<"robot.torques">,
                            cca::observe<"robot.abducted">,
                            cca::observe<"robot.orientation">,
                            cca::observe<"robot.acceleration">,
                            cca::observe<"robot.angular_velocity">,
                            cca::observe<"robot.contacts">,
                            cca::observe<"robot.foot_loads">> {};

using names = std::set<std::string>;
const names every_sensor{"angles",       "velocities",       "torques",  "abducted",  "orientation",
                         "acceleration", "angular_velocity", "contacts", "foot_loads"};

using readings = std::map<std::string, std::vector<double>>;  // of all beats, by the path of the port

template <class World>
readings of_run(const sim::uncertainty& u) {
  cca::controller<stepped<World>> c;
  c.load();
  c.template set<"robot.simulator">(u);
  auto& simulator = c.template get<"robot.simulator">();
  simulator.put_down(World(sim::drawn_ground(u), sim::standing_posture(), sim::drawn_settings(u)));
  c.start();
  readings all;
  for (int k = 0; k < 600; ++k) {
    REQUIRE(c.step());
    c.observed([&](const cca::observation& one) {
      auto& values = all[std::string(one.path.substr(6))];  // past "robot."
      values.insert(values.end(), one.values.begin(), one.values.end());
    });
  }
  return all;
}

names of_difference(const readings& a, const readings& b) {
  names all;
  for (const auto& [name, values] : a)
    if (values != b.at(name)) all.insert(name);
  return all;
}

// What a kind of a sensor changes; nothing, if it acts on what the robot does.
names sensors_of(std::string_view kind) {
  if (kind.starts_with("orientation")) return {"orientation"};
  if (kind.starts_with("gyroscope")) return {"angular_velocity"};
  if (kind.starts_with("angle")) return {"angles", "abducted"};
  if (kind.starts_with("velocity")) return {"velocities"};
  if (kind.starts_with("torque")) return {"torques"};
  if (kind.starts_with("force")) return {"foot_loads"};
  if (kind == "delay of sensors" || kind == "loss of readings") return every_sensor;
  return {};
}

template <class World>
void check(const uncertain::kind& kind, const readings& ideal) {
  sim::uncertainty u{};
  u.seed = 3;
  kind.set(u, kind.amounts.back());
  const names differing = of_difference(ideal, of_run<World>(u));
  const names expected = sensors_of(kind.name);
  CAPTURE(kind.name);
  if (kind.name == "slope" || kind.name == "steps")  // they begin further ahead
    CHECK(sim::drawn_ground(u).height(3) != 0);
  else if (expected.empty()) CHECK(differing.contains("angles"));
  else CHECK(differing == expected);
}

}  // namespace

TEST_SUITE("uncertain: kinds") {
  TEST_CASE("each kind of the tables changes the readings that it is about, and no others") {
    const readings ideal = of_run<sim::compiled_oncilla_world>({});
    REQUIRE(ideal.size() == every_sensor.size());
    for (const uncertain::kind& kind : uncertain::kinds())
      if (kind.in_compiled_physics) check<sim::compiled_oncilla_world>(kind, ideal);
  }

  TEST_CASE("what compiled physics does not draw changes the robot of the engine") {
    const readings ideal = of_run<sim::world>({});
    for (const uncertain::kind& kind : uncertain::kinds())
      if (!kind.in_compiled_physics) check<sim::world>(kind, ideal);
  }
}
