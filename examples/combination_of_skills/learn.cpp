// Learns the shape of a trot from a recording of it, and writes it to the file that the Combination of Skills
// reads.
//
//   combination_of_skills_learn --out trot.shape
//
// The robot of examples/trot trots in the simulator. The commands of its gait are recorded, with their phase
// and amplitude, and shown to the module. The module learns in a batch, and its life-cycle saves it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include <cca/main/descriptions.hpp>
#include <cca/main/run_program.hpp>
#include <cca/runtime/interruption.hpp>

#include "../trot/rollout.hpp"
#include "architecture.hpp"

namespace {

namespace oncilla = cca::robots::oncilla;

using angles = oncilla::leg_angles::vector_type;

// [record]
struct recorded_trot : cca::graph<cca::rate<1000>,
                                  cca::node<"trot", trot::simulated_trot>,
                                  cca::observe<"trot.cpg.*">,
                                  cca::observe<"trot.gait.*">> {};
// [record end]

struct moment {
  double phase = 0, amplitude = 0;
  angles commanded = angles::Zero();
};

// The gait that is taught: that of examples/trot on straighter front legs. From the posture in which it stops
// the paw reaches a ball that lies ahead; from the lower posture of examples/trot it does not.
trot::gait::parameters taught() {
  using trot::degrees;
  return {{degrees(48.8), degrees(92.5), degrees(13.5), degrees(40.0)},
          {degrees(39.5), degrees(84.0), degrees(16.5), degrees(52.0)},
          0.585,
          0.65,
          degrees(2.5),
          -0.044,
          {0.0, 0.5, 0.374, -0.126},
          0.0};
}

// The angles around which the gait swings.
angles neutral(const trot::gait::parameters& p) {
  angles q;
  q << p.front.hip, p.front.hip, p.hind.hip, p.hind.hip, p.front.knee, p.front.knee, p.hind.knee, p.hind.knee;
  return q;
}

std::vector<moment> recorded(double seconds, const cca::interruption& interrupted) {
  cca::controller<recorded_trot> c;
  c.load();
  c.set<"trot.gait">(taught());
  auto speed = c.get<"trot.throttle">().p;
  speed.speed = 0.66, speed.intercept = 0.191, speed.slope = 1.076;  // as fast as this gait trots
  c.set<"trot.throttle">(speed);
  auto straight_on = c.get<"trot.posture">().p;  // without leaning, which is no part of the shape
  straight_on.heading = 1.0;
  straight_on.drift = 0.4;
  straight_on.upright = 0.0;
  straight_on.level = 0.0;
  straight_on.damp = 0.0;
  c.set<"trot.posture">(straight_on);
  c.get<"trot.robot.simulator">().put_down(cca::sim::world(
      cca::sim::terrain::flat(), trot::put_down(c.get<"trot.gait">().p, cca::sim::disturbance::none())));
  c.start();
  std::vector<moment> all;
  const double settled = 2;  // s, then it trots steadily
  while (!interrupted && 1e-3 * static_cast<double>(c.beat_index()) < settled + seconds) {
    c.step();
    moment now;
    c.observed([&](const cca::observation& one) {
      if (one.path == "trot.cpg.phase") now.phase = one.values[0];
      if (one.path == "trot.cpg.amplitude") now.amplitude = one.values[0];
      if (one.path == "trot.gait.angles")
        std::copy(one.values.begin(), one.values.end(), now.commanded.begin());
    });
    if (1e-3 * static_cast<double>(c.beat_index()) > settled) all.push_back(now);
  }
  return all;
}

// [teach]
// Plays the recording back, beat by beat.
struct playback {
  auto process(cca::beat now) -> std::tuple<cca::out<"phase", cca::over<cca::phase, skills::stride>>,
                                            cca::out<"amplitude", cca::over<cca::amplitude, skills::stride>>,
                                            cca::out<"angles", oncilla::leg_angles>,
                                            cca::out<"neutral", oncilla::leg_angles>> {
    const moment& m = played[static_cast<std::size_t>(now.index()) % played.size()];
    return {m.phase, m.amplitude, m.commanded, around};
  }
  std::vector<moment> played{moment{}};
  angles around = angles::Zero();
};

struct teaching : cca::graph<cca::rate<1000>,
                             cca::node<"recording", playback>,
                             cca::node<"dmp", skills::shape_of_trot<20000>, cca::timed<1>>,
                             cca::wire<"recording.phase", "dmp.phase">,
                             cca::wire<"recording.amplitude", "dmp.amplitude">,
                             cca::wire<"recording.neutral", "dmp.reference">,
                             cca::wire<"recording.angles", "dmp.demonstration">,
                             cca::observe<"dmp.*">> {};
// [teach end]

struct options {
  std::string out = "trot.shape";
  double seconds = 8;
  bool quiet = false;
};

void offer(cca::command_line& line, options& o) {
  line.text("--out FILE", o.out, "the learned shape (trot.shape)");
  line.number("--seconds S", o.seconds, 1, 19, "of trot that are recorded (8)");
  line.flag("--quiet", o.quiet, "prints nothing");
  cca::offer_descriptions<cca::controller<teaching>>(line);
}

// The largest distance between the module's command and the recording, rad, after the start.
double greatest_error(cca::controller<teaching>& c) {
  double worst = 0;
  const auto& played = c.get<"recording">().played;
  for (std::size_t i = 0; i < played.size(); ++i) {
    c.step();
    const moment& m = played[static_cast<std::size_t>(c.beat_index() - 1) % played.size()];
    c.observed([&](const cca::observation& one) {
      if (one.path != "dmp.command" || i < 200) return;
      for (std::size_t j = 0; j < 8; ++j)
        worst = std::max(worst, std::abs(one.values[j] - m.commanded[static_cast<int>(j)]));
    });
  }
  return worst;
}

int run(const options& o) {
  const cca::interruption interrupted;  // ctrl-c: nothing is written, since a part of a stride is no shape
  cca::controller<teaching> c;
  auto& dmp = c.get<"dmp">();
  if (!dmp.p.files.save.assign(o.out)) throw cca::command_line_error(o.out + ": this name is too long");
  c.get<"recording">().played = recorded(o.seconds, interrupted);
  if (interrupted) {
    std::cerr << "combination_of_skills_learn: interrupted; nothing is written\n";
    return interrupted.exit_code();
  }
  c.get<"recording">().around = neutral(taught());
  c.load();
  c.start();
  dmp.learning.collect();
  c.run(cca::for_beats<1000>{});
  for (std::size_t i = 1000; i < c.get<"recording">().played.size(); ++i) c.step();
  const auto batch = dmp.learning.begin_batch(dmp.p.settings);
  dmp.learning.hand_over(batch());
  const double error = greatest_error(c);
  c.stop();
  c.save();
  if (!o.quiet)
    std::printf("learned from %zu beats of trot, written to %s; it follows the recording within %.4f rad\n",
                c.get<"recording">().played.size(), o.out.c_str(), error);
  return 0;
}

}  // namespace

int main(int count, char** words) {
  options o;
  cca::command_line line("learns the shape of a trot from a recording in the simulator");
  offer(line, o);
  return cca::run_program(count, words, line, [&] { return run(o); });
}
