// A Sequencer and its skills: their statuses start the next step, a timeout leads to another step.
#include <string>
#include <string_view>

#include <cca/adaptive/reaching_criterion.hpp>
#include <cca/adaptive/sequencer.hpp>
#include <cca/motor/vite.hpp>

#include "../picture.hpp"
#include "rig.hpp"

using namespace adaptive_test;

namespace {

// [sequencer]
struct plan
    : cca::steps<
          cca::step<"trot">,
          cca::step<"stop", cca::after<1000>>,
          cca::step<"reach", cca::is<"cpg.status", cca::ode_status::converged>, cca::or_after<3000, "trot">>,
          cca::step<"hold",
                    cca::is<"arm.status.component", cca::component_status::reached>,
                    cca::held_for<100>,
                    cca::or_after<4000, "lift">,
                    cca::then<"lift">>,
          cca::step<"lift", cca::after<300>, cca::then<"trot">>> {};

struct leader {  // turns the step into inputs of the skills
  auto process(cca::in<"step", cca::step_port> step)
      -> std::tuple<cca::out<"amplitude", cca::over<cca::amplitude, stride>>, cca::out<"target", leg>> {
    const int now = static_cast<int>(step[cca::step_axis{}]);
    const bool reaching = now == plan::at<"reach"> || now == plan::at<"hold">;
    return {now == plan::at<"trot"> ? 1.0 : -1.0,
            reaching ? Eigen::Vector2d(0.5, -0.2) : Eigen::Vector2d(0.1, -0.8)};
  }
};

// VITE as the module of an adaptive component; `named` maps its port names.
struct arm : cca::adaptive_component<cca::vite<leg>,
                                     cca::reaching_goal<leg>,
                                     cca::named<"target", "position", "status">> {};

struct held_arm {  // follows until somebody holds it
  auto process(cca::in<"command", leg> wanted) -> cca::out<"angles", leg> {
    return angles += held ? 0 * angles : Eigen::Vector2d(0.2 * (wanted.vector() - angles));
  }
  Eigen::Vector2d angles{0, 0};
  bool held = false;
};

struct skills : cca::graph<cca::rate<1000>,
                           cca::node<"sequencer", cca::sequencer<"*.status.*", plan>, cca::timed<10>>,
                           cca::node<"leader", leader>,
                           cca::node<"cpg", cca::hopf<stride>, cca::timed<1>>,
                           cca::node<"arm", arm>,
                           cca::node<"robot", held_arm>,
                           cca::wire<"sequencer.step", "leader.step">,
                           cca::wire<"leader.amplitude", "cpg.amplitude", cca::latest>,
                           cca::wire<"leader.target", "arm.reference", cca::latest>,
                           cca::wire<"arm.command", "robot.command">,
                           cca::wire<"robot.angles", "arm.feedback", cca::delayed<1>>> {};
// [sequencer end]

}  // namespace

namespace {

std::vector<std::string> names_over(cca::controller<skills>& c, int beats) {
  std::vector<std::string> names;
  for (int k = 0; k < beats; ++k) {
    c.step();
    const std::string name(c.get<"sequencer">().steps.name());
    if (names.empty() || names.back() != name) names.push_back(name);
  }
  return names;
}

using name_list = std::vector<std::string>;

}  // namespace

TEST_CASE("a sequencer goes from skill to skill by their statuses") {
  cca::controller<skills> c;
  c.get<"arm.criterion">().p.limits = {0.005, 0.01, cca::infinity, 0.0};
  c.load();
  c.start();
  auto names = names_over(c, 6000);
  REQUIRE(names.size() > 6);
  names.resize(6);
  CHECK(names == name_list{"trot", "stop", "reach", "hold", "lift", "trot"});
  CHECK(!c.get<"sequencer">().steps.timed_out());
  CHECK(c.fault().reason() == std::string());
}

TEST_CASE("a timeout leads to another step") {
  cca::controller<skills> c;
  c.get<"arm.criterion">().p.limits = {0.005, 0.01, cca::infinity, 0.0};
  c.load();
  c.start();
  CHECK(names_over(c, 2000).back() == "reach");
  const auto reached_at = c.beat_index();
  c.get<"robot">().held = true;
  std::int64_t lifted_at = 0;
  for (int k = 0; k < 6000 && lifted_at == 0; ++k) {
    c.step();
    if (c.get<"sequencer">().steps.in<"lift">()) lifted_at = c.beat_index();
    CHECK(!c.get<"sequencer">().steps.in<"hold">());
  }
  CHECK(lifted_at - reached_at <= 4010);
  CHECK(lifted_at - reached_at > 3000);
  CHECK(c.get<"sequencer">().steps.timed_out());
  CHECK(names_over(c, 400) == name_list{"lift", "trot"});
}

namespace {

struct nothing {
  auto process(cca::beat) -> cca::out<"status", cca::ode_status_port> { return 0.0; }
};
// A condition of one's own that does not say what it asks for: the compiler does not know.
struct own_condition {
  template <class Heard>
  static bool holds(const Heard& heard) {
    return heard.template value<"nobody.status">() > 0;
  }
};
struct misspelt : cca::steps<cca::step<"first">,
                             cca::step<"second", cca::after<1000>>,
                             cca::step<"third", own_condition>> {};
struct deaf : cca::graph<cca::rate<1000>,
                         cca::node<"somebody", nothing>,
                         cca::node<"sequencer", cca::sequencer<"*.status.*", misspelt>, cca::timed<1>>> {};

struct counted : cca::steps<cca::step<"a">,
                            cca::step<"b",
                                      cca::all<cca::after<10>, cca::no<cca::is<"somebody.status", 1>>>,
                                      cca::held_for<5>>> {};
struct counting : cca::graph<cca::rate<1000>,
                             cca::node<"somebody", nothing>,
                             cca::node<"sequencer", cca::sequencer<"*.status.*", counted>, cca::timed<1>>> {};

}  // namespace

TEST_CASE("a path that nobody publishes is a fault in the first beat, not one in the step that asks for it") {
  cca::controller<deaf> c;
  c.load();
  c.start();
  c.step();
  CHECK(c.state() == cca::state::faulted);
  CHECK(std::string(c.fault().reason()).find("nobody publishes") != std::string::npos);
}

TEST_CASE("beats count from the start of the step, and a condition must hold without a break") {
  cca::controller<counting> c;
  c.load();
  c.start();
  c.run(cca::for_beats<15>{});  // the condition holds from beat 10 on, the step runs since beat 0
  CHECK(c.get<"sequencer">().steps.in<"a">());
  c.step();
  CHECK(c.get<"sequencer">().steps.in<"b">());
  const std::size_t before = laws::allocations();
  for (int k = 0; k < 100; ++k) c.step();
  CHECK(laws::allocations() == before);
}

namespace {

// The sequencer and a skill of its own in an inner graph, other skills around it.
struct led : cca::steps<cca::step<"wait">,
                        cca::step<"act", cca::is<"arm.status.component", cca::component_status::reached>>> {};
struct mind : cca::graph<cca::node<"sequencer", cca::sequencer<"*.status.*", led>, cca::timed<1>>,
                         cca::expose<"sequencer.step", "step">> {};
struct still {
  auto process(cca::beat) -> cca::out<"angles", leg> { return Eigen::Vector2d(0.1, -0.8); }
};
struct led_from_inside : cca::graph<cca::rate<1000>,
                                    cca::node<"mind", mind>,
                                    cca::node<"target", still>,
                                    cca::node<"arm", arm>,
                                    cca::node<"robot", held_arm>,
                                    cca::wire<"target.angles", "arm.reference">,
                                    cca::wire<"arm.command", "robot.command">,
                                    cca::wire<"robot.angles", "arm.feedback", cca::delayed<1>>> {};

}  // namespace

TEST_CASE("a sequencer in an inner graph hears the skills around it") {
  cca::controller<led_from_inside> c;
  c.get<"arm.criterion">().p.limits = {0.005, 0.01, cca::infinity, 0.0};
  c.load();
  c.start();
  c.run(cca::for_beats<10>{});
  CHECK(c.get<"mind.sequencer">().steps.in<"wait">());
  c.run(cca::for_beats<4000>{});
  CHECK(c.get<"mind.sequencer">().steps.in<"act">());
  CHECK(c.state() == cca::state::started);
}

namespace {

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  n0["sequencer<br/><i>100 Hz</i>"]
  n1["leader<br/><i>100 Hz</i>"]
  n2["cpg<br/><i>1000 Hz</i>"]
  n6["robot<br/><i>restless</i>"]
  subgraph g1["arm"]
    n3["module<br/><i>1000 Hz</i>"]
    n4["criterion<br/><i>1000 Hz</i>"]
    n5["status<br/><i>1000 Hz</i>"]
  end
  n0 -- "step<br/>step_port, 100 Hz" --> n1
  n1 -- "amplitude<br/>over&lt;amplitude, stride&gt;, 100 Hz" --> n2
  n1 -- "target<br/>leg, 100 Hz" --> n3
  n1 -- "target<br/>leg, 100 Hz" --> n4
  n6 -. "angles → feedback<br/>leg<br/>delayed 1" .-> n4
  n3 -- "status → ode<br/>ode_status_port, 1000 Hz" --> n5
  n4 -- "state → criterion<br/>criterion_port, 1000 Hz" --> n5
  n3 -- "position → command<br/>leg" --> n6
)";  // [picture end]

}  // namespace

TEST_CASE("the picture of a sequencer and its skills is the one on its page") {
  test::check_picture<skills>(picture);
}
