// The example of docs/motor.md: from locomotion to reaching (seed, section 6.3), for one leg; and a graph of
// all motor components, which the rules accept.
#include <string>
#include <string_view>

#include <cca/motor/dmp_discrete.hpp>
#include <cca/motor/dmp_pose.hpp>
#include <cca/motor/dmp_rhythmic.hpp>
#include <cca/motor/gait_network.hpp>
#include <cca/motor/gmr.hpp>
#include <cca/motor/hmm_motion.hpp>
#include <cca/motor/hopf.hpp>
#include <cca/motor/pid.hpp>
#include <cca/motor/rcpg.hpp>
#include <cca/motor/vite.hpp>

#include "../picture.hpp"
#include "rig.hpp"

using namespace motor_test;

namespace {

// [skills]
// Trots for two seconds, then rests the oscillator and reaches.
struct script {
  auto process(cca::beat now)
      -> std::tuple<cca::out<"amplitude", cca::over<cca::amplitude, stride>>, cca::out<"target", leg>> {
    const bool trot = now.index() < 2000;
    return {trot ? 1.0 : -1.0, trot ? Eigen::Vector2d(0.1, -0.8) : Eigen::Vector2d(0.6, -1.2)};
  }
};

struct skills : cca::graph<cca::rate<1000>,
                           cca::node<"script", script>,
                           cca::node<"cpg", cca::hopf<stride>, cca::timed<1>>,
                           cca::node<"reach", cca::vite<leg>, cca::timed<1>>,
                           cca::node<"dmp", cca::dmp_rhythmic<leg, stride, 10>, cca::timed<1>>,
                           cca::wire<"script.amplitude", "cpg.amplitude">,
                           cca::wire<"script.target", "reach.target">,
                           cca::wire<"cpg.phase", "dmp.phase">,
                           cca::wire<"cpg.amplitude", "dmp.amplitude">,
                           cca::wire<"reach.position", "dmp.goal">,
                           cca::expose<"dmp.position", "angles">,
                           cca::expose<"dmp.status", "status">> {};
// [skills end]

struct listener {
  void process(cca::in<"angles", leg> a, cca::in<"status", cca::ode_status_port> s) {
    angles = a.vector(), status = s.as<cca::ode_status>();
  }
  Eigen::Vector2d angles{0, 0};
  cca::ode_status status{};
};
struct heard : cca::graph<cca::rate<1000>,
                          cca::node<"leg", skills>,
                          cca::node<"ear", listener>,
                          cca::wire<"leg.angles", "ear.angles">,
                          cca::wire<"leg.status", "ear.status">> {};

struct trunk : cca::frame<"trunk"> {};
struct hand : cca::frame<"hand"> {};
struct hand_in_trunk : cca::space<cca::pose<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};
struct lf : cca::dimension<"left_front"> {};
struct rf : cca::dimension<"right_front"> {};
struct lh : cca::dimension<"left_hind"> {};
struct rh : cca::dimension<"right_hind"> {};
struct front : cca::space<cca::phase, cca::axes<lf>> {};

struct sources {
  auto process() -> std::tuple<cca::out<"legs", cca::over<cca::amplitude, lf, rf, lh, rh>>,
                               cca::out<"angles", leg>,
                               cca::out<"pose", hand_in_trunk>,
                               cca::out<"phase", front>> {
    return {Eigen::Vector4d(1, 1, 1, 1), Eigen::Vector2d(0.3, 0.1), cca::out<"pose", hand_in_trunk>{}, 0.3};
  }
};

struct all_of_them : cca::graph<cca::rate<1000>,
                                cca::node<"from", sources>,
                                cca::node<"network", cca::gait_network<lf, rf, lh, rh>, cca::timed<1>>,
                                cca::wire<"from.legs", "network.amplitude">,
                                cca::node<"dmp", cca::dmp_discrete<leg, 20>, cca::timed<1>>,
                                cca::wire<"from.angles", "dmp.goal">,
                                cca::node<"pose", cca::dmp_pose<hand_in_trunk, hand, 8>, cca::timed<1>>,
                                cca::wire<"from.pose", "pose.goal">,
                                cca::node<"servo", cca::pid<leg, leg>, cca::timed<1>>,
                                cca::wire<"dmp.position", "servo.reference">,
                                cca::wire<"from.angles", "servo.measured">,
                                cca::node<"rcpg", cca::rcpg<leg, 30>, cca::timed<10>>,
                                cca::node<"gmr", cca::gmr<front, leg, 4>>,
                                cca::wire<"from.phase", "gmr.input">,
                                cca::node<"hmm", cca::hmm_motion<leg, 3>, cca::timed<1>>,
                                cca::wire<"gmr.position", "hmm.position">> {};

static_assert(cca::well_formed<heard> && cca::well_formed<all_of_them>);

}  // namespace

TEST_CASE("a leg swings around a goal and, when the oscillator rests, reaches another goal") {
  cca::controller<heard> c;
  for (int i = 0; i < 10; ++i)
    c.get<"leg.dmp">().p.weights.col(i) =
        150 * Eigen::Vector2d(std::sin(0.2 * cca::pi * i), std::cos(0.2 * cca::pi * i));
  c.load();
  c.start();
  double lowest = 9, highest = -9;
  for (int k = 0; k < 2000; ++k) {
    c.step();
    if (k < 1000) continue;
    lowest = std::min(lowest, c.get<"ear">().angles[0]),
    highest = std::max(highest, c.get<"ear">().angles[0]);
    CHECK(c.get<"ear">().status == cca::ode_status::transient);
  }
  CHECK(highest - lowest > 0.3);
  CHECK((highest + lowest) / 2 == doctest::Approx(0.1).epsilon(0.2));
  const std::size_t before = laws::allocations();
  for (int k = 0; k < 4000; ++k) c.step();
  CHECK(laws::allocations() == before);
  // The remaining oscillation, `ember`, is a thousandth.
  CHECK((c.get<"ear">().angles - Eigen::Vector2d(0.6, -1.2)).norm() < 2e-3);
}

TEST_CASE("all motor components in one graph run without allocation") {
  cca::controller<all_of_them> c;
  c.load();
  c.start();
  const std::size_t before = laws::allocations();
  for (int k = 0; k < 500; ++k) c.step();
  CHECK(laws::allocations() == before);
}

namespace {

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  n0["script<br/><i>1000 Hz</i>"]
  n1["cpg<br/><i>1000 Hz</i>"]
  n2["reach<br/><i>1000 Hz</i>"]
  n3["dmp<br/><i>1000 Hz</i>"]
  n0 -- "amplitude<br/>over&lt;amplitude, stride&gt;, 1000 Hz" --> n1
  n0 -- "target<br/>leg, 1000 Hz" --> n2
  n1 -- "phase<br/>over&lt;phase, stride&gt;, 1000 Hz" --> n3
  n1 -- "amplitude<br/>over&lt;amplitude, stride&gt;, 1000 Hz" --> n3
  n2 -- "position → goal<br/>leg" --> n3
)";  // [picture end]

}  // namespace

TEST_CASE("the picture of locomotion to reaching is the one on its page") {
  test::check_picture<skills>(picture);
}
