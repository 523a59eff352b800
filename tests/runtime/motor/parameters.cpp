// The parameters of the motor components from a TOML file: read with their units, wrong ones refused by name.
#include <string>
#include <string_view>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
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

#include "../config/shown_components.hpp"

namespace {

struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct left_front : cca::dimension<"left_front"> {};
struct right_front : cca::dimension<"right_front"> {};
struct left_hind : cca::dimension<"left_hind"> {};
struct right_hind : cca::dimension<"right_hind"> {};
struct turn : cca::dimension<"turn"> {};
struct leg : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
struct trunk : cca::frame<"trunk"> {};
struct hand : cca::frame<"hand"> {};
struct hand_pose : cca::space<cca::pose<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};
struct leg_torques : cca::space<cca::joint_torques, cca::axes<hip, knee>> {};

struct elements : config_test::shown_components<elements> {
  static constexpr std::string_view file = "motor.toml";
  cca::hopf<turn> cpg;
  cca::gait_network<left_front, right_front, left_hind, right_hind> network;
  cca::vite<leg> reach;
  cca::dmp_discrete<leg, 3> stroke;
  cca::dmp_rhythmic<leg, turn, 3> swing;
  cca::dmp_pose<hand_pose, hand, 2> grasp;
  cca::pid<leg, leg_torques> servo;
  cca::rcpg<leg, 4, 2> pattern;
  cca::gmr<cca::over<cca::phase, turn>, leg, 2> motion;
  cca::hmm_motion<leg, 2> parts;

  template <class Self, class F>
  static void each(Self& self, F& f) {
    f("cpg", self.cpg);
    f("network", self.network);
    f("reach", self.reach);
    f("stroke", self.stroke);
    f("swing", self.swing);
    f("grasp", self.grasp);
    f("servo", self.servo);
    f("pattern", self.pattern);
    f("motion", self.motion);
    f("parts", self.parts);
  }
};

void refuses(std::string_view text, std::string_view words) {
  elements e;
  const std::string before = e.text();
  CHECK_EQ(e.refusal(text), words);
  CHECK_EQ(e.text(), before);
}

}  // namespace

TEST_CASE("the parameters of the motor components are read with their units") {
  elements e;
  CHECK_EQ(e.refusal(R"([cpg]
frequency = "2500 mHz"
convergence = 8.0
settling = {below = 0.01, above = 0.02}
[network]
gait = "walk"
coupling = 6.0
[reach]
rise = "250 ms"
exponent = 3
[stroke]
duration = "800 ms"
weights = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]
scaled = false
[swing]
frequency = 1.5
[servo]
proportional = [20.0, 10.0]
filter = "5 ms"
tracking = 0.25
[pattern]
seed = 7
[grasp]
duration = "1.5 s"
decay = 4.0
weights = [[1.0, 2.0], [3.0, 4.0], [5.0, 6.0], [7.0, 8.0], [9.0, 10.0], [11.0, 12.0]]
[motion.mixture]
priors = [0.25, 0.75]
means = [[0.5, 1.0], [2.0, 3.0], [4.0, 5.0]]
covariances = [[[1.0, 0.0, 0.0], [0.0, 1.0, 0.5], [0.0, 0.5, 1.0]], [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]]
[parts]
transitions = [[0.9, 0.1], [0.25, 0.75]]
[parts.mixture]
priors = [1.0, 0.0]
)"),
           "");
  CHECK_EQ(e.cpg.p.frequency.value(), 2.5);
  CHECK_EQ(e.cpg.p.convergence, 8);
  CHECK_EQ(e.cpg.p.settling.above, 0.02);
  CHECK_EQ(e.network.p.gait, cca::gait::walk);
  CHECK_EQ(e.network.p.coupling, 6);
  CHECK_EQ(e.reach.p.rise.value(), 0.25);
  CHECK_EQ(e.reach.p.exponent, 3);
  CHECK_EQ(e.reach.p.speed, 7.5);  // a parameter that the file lacks stays
  CHECK_EQ(e.stroke.p.duration.value(), 0.8);
  CHECK_EQ(e.stroke.p.weights(1, 0), 4);
  CHECK_EQ(e.stroke.p.scaled, false);
  CHECK_EQ(e.swing.p.frequency.value(), 1.5);
  CHECK_EQ(e.servo.p.proportional, Eigen::Vector2d(20, 10));
  CHECK_EQ(e.servo.p.filter.value(), 0.005);
  CHECK_EQ(e.servo.p.tracking.value(), 0.25);
  CHECK_EQ(e.pattern.p.seed, 7);
  CHECK_EQ(e.grasp.p.duration.value(), 1.5);
  CHECK_EQ(e.grasp.p.decay, 4);
  CHECK_EQ(e.grasp.p.weights(5, 1), 12);
  CHECK_EQ(e.grasp.p.stiffness, 25);
  CHECK_EQ(e.motion.p.mixture.priors, Eigen::Vector2d(0.25, 0.75));
  CHECK_EQ(e.motion.p.mixture.means(2, 0), 4);
  CHECK_EQ(e.motion.p.mixture.covariances[0](1, 2), 0.5);
  CHECK_EQ(e.motion.p.mixture.covariances[1](0, 0), 2);
  CHECK_EQ(e.parts.p.transitions(1, 0), 0.25);
  CHECK_EQ(e.parts.p.mixture.priors, Eigen::Vector2d(1, 0));
  elements again;
  CHECK_EQ(again.refusal(e.text()), "");
  CHECK_EQ(again.text(), e.text());
}

TEST_CASE("wrong parameters of the motor components are refused by name") {
  refuses("[cpg]\nfrequency = \"2.5 s\"",
          "motor.toml:2: cpg.frequency: unknown unit \"s\" in \"2.5 s\", expected Hz, mHz or kHz");
  refuses("[cpg]\nfrequency = -1.0",
          "motor.toml:2: cpg.frequency: -1 Hz is out of range, expected 0 to 100 Hz");
  refuses("[network]\ngait = \"tort\"",
          "motor.toml:2: network.gait: unknown name \"tort\", expected walk, trot, pace or bound");
  refuses("[reach]\nrise = \"20 mm\"",
          "motor.toml:2: reach.rise: unknown unit \"mm\" in \"20 mm\", expected s, ms, us or min");
  refuses("[reach]\nexponent = 0", "motor.toml:2: reach.exponent: 0 is out of range, expected 1 to 8");
  refuses("[stroke]\nduration = \"0 s\"",
          "motor.toml:2: stroke.duration: 0 s is out of range, expected 0.001 to 1000 s");
  refuses("[stroke]\nweights = [[1.0, 2.0], [3.0, 4.0]]",
          "motor.toml:2: stroke.weights[0]: expected an array of 3, got one of 2\nmotor.toml:2: "
          "stroke.weights[1]: expected an array of 3, got one of 2");
  refuses("[swing]\nfrequncy = 1.0",
          "motor.toml:2: swing.frequncy: unknown parameter, did you mean `frequency`?");
  refuses("[servo]\nproportional = [-1.0, 1.0]", "motor.toml:1: servo: a gain is negative");
  refuses("[servo]\nfilter = \"fast\"",
          "motor.toml:2: servo.filter: expected a number with its unit (s, ms, us or min), got a string "
          "\"fast\"");
  refuses("[pattern]\nleak = 1.5", "motor.toml:2: pattern.leak: 1.5 is out of range, expected 0 to 1");
  refuses("[cpg]\nsettling = {below = 0.2, above = 0.1}",
          "motor.toml:2: cpg.settling: `below` is larger than `above`");
  refuses("[grasp]\nduration = \"1.5 m\"",
          "motor.toml:2: grasp.duration: unknown unit \"m\" in \"1.5 m\", expected s, ms, us or min");
  refuses(
      "[grasp]\nscaled = 1",
      "motor.toml:2: grasp.scaled: expected true or false, got the integer 1; for example `scaled = true`");
  refuses(
      "[motion.mixture]\npriors = [0.5, -0.5]",
      "motor.toml:1: motion.mixture: the priors are not weights: no prior may be negative, and not all may "
      "be zero");
  refuses(
      "[motion.mixture]\ncovariances = [[[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [[1.0, 0.0, "
      "0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]]",
      "motor.toml:1: motion.mixture: a covariance is not positive definite over the input");
  refuses("[parts]\ntransitions = [[0.9, 0.2], [0.25, 0.75]]",
          "motor.toml:1: parts: a row of `transitions` is not a probability distribution: no entry may be "
          "negative, the sum must be 1");
  refuses("[parts.mixture]\npriors = [1.0]",
          "motor.toml:2: parts.mixture.priors: expected an array of 2, got one of 1");
}
