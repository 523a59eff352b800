// The DMP Transformation System as a Tracker (seed, figure 6.3): it learns a demonstrated shape and follows
// it.
#include "../picture.hpp"
#include "rig.hpp"

using namespace adaptive_test;

namespace {

constexpr double hertz = 1.5;

// [tracker]
struct dmp : cca::tracker<cca::dmp_rhythmic_module<leg, stride, 25>, cca::tracking<leg>> {};

// The demonstration: two harmonics around a reference.
struct teacher {
  auto process(cca::in<"phase", cca::over<cca::phase, stride>> phase)
      -> std::tuple<cca::out<"angles", leg>, cca::out<"centre", leg>> {
    const double f = phase[stride{}];
    return {Eigen::Vector2d(0.1 + 0.3 * std::sin(f), -0.8 + 0.2 * std::cos(2 * f + 1)),
            Eigen::Vector2d(0.1, -0.8)};
  }
};
struct servo {  // follows with a small delay
  auto process(cca::in<"command", leg> wanted) -> cca::out<"angles", leg> {
    return angles += 0.2 * (wanted.vector() - angles);
  }
  Eigen::Vector2d angles{0, 0};
};
struct wish {
  auto process(cca::beat) -> std::tuple<cca::out<"amplitude", cca::over<cca::amplitude, stride>>,
                                        cca::out<"frequency", cca::over<cca::frequency, stride>>> {
    return {1.0, hertz};
  }
};
struct ear {  // observes everything under dmp.status
  void process(cca::observe<"dmp.status.*"> all) {
    for (const cca::observation& one : all) {
      if (one.path == "dmp.status.component") component = static_cast<cca::component_status>(one.values[0]);
      if (one.path == "dmp.status.module")
        learning = static_cast<cca::learning>(one.values[0]),
        region = static_cast<cca::trained_region>(one.values[1]);
      if (one.path == "dmp.status.ode") ode = static_cast<cca::ode_status>(one.values[0]);
    }
    heard = all.size();
  }
  std::size_t heard = 0;
  cca::component_status component{};
  cca::learning learning{};
  cca::trained_region region{};
  cca::ode_status ode{};
};

struct shown : cca::graph<cca::rate<1000>,
                          cca::node<"wish", wish>,
                          cca::node<"cpg", cca::hopf<stride>, cca::timed<1>>,
                          cca::node<"teacher", teacher>,
                          cca::node<"dmp", dmp>,
                          cca::node<"servo", servo>,
                          cca::node<"ear", ear>,
                          cca::wire<"wish.amplitude", "cpg.amplitude">,
                          cca::wire<"wish.frequency", "cpg.frequency">,
                          cca::wire<"wish.frequency", "dmp.frequency">,
                          cca::wire<"cpg.phase", "teacher.phase">,
                          cca::wire<"cpg.phase", "dmp.phase">,
                          cca::wire<"cpg.amplitude", "dmp.amplitude">,
                          cca::wire<"teacher.centre", "dmp.reference">,
                          cca::wire<"teacher.angles", "dmp.demonstration">,
                          cca::wire<"dmp.command", "servo.command">,
                          cca::wire<"servo.angles", "dmp.feedback", cca::delayed<1>>> {};
// [tracker end]

struct pictured : cca::graph<cca::rate<1000>,
                             cca::node<"dmp", dmp>,
                             cca::expose<"dmp.phase", "phase">,
                             cca::expose<"dmp.amplitude", "amplitude">,
                             cca::expose<"dmp.reference", "reference">,
                             cca::expose<"dmp.feedback", "feedback">> {};

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  subgraph g1["dmp"]
    n0["module<br/><i>1000 Hz</i>"]
    n1["criterion<br/><i>1000 Hz</i>"]
    n2["status<br/><i>1000 Hz</i>"]
  end
  n0 -- "command → target<br/>leg" --> n1
  n0 -- "ode<br/>ode_status_port, 1000 Hz" --> n2
  n0 -- "module<br/>module_status_port, 1000 Hz" --> n2
  n1 -- "state → criterion<br/>criterion_port, 1000 Hz" --> n2
)";  // [picture end]

cca::controller<shown> started() {
  cca::controller<shown> c;
  c.get<"dmp.criterion">().p.limits = {0.05, 0.1, 1.0, 0.2};
  c.load();
  c.start();
  return c;
}

}  // namespace

TEST_CASE("a tracker learns a demonstrated shape in a batch and follows it") {
  auto c = started();
  auto& module = c.get<"dmp.module">();
  auto& heard = c.get<"ear">();
  c.run(cca::for_beats<2000>{});
  CHECK(heard.heard == 3);
  CHECK(heard.learning == cca::learning::idle);
  CHECK(heard.region == cca::trained_region::outside);
  // Untrained, its command has no shape yet; following it counts as reached.
  CHECK(heard.component == cca::component_status::reached);
  CHECK(heard.ode == cca::ode_status::converged);

  module.learning.collect();
  c.run(cca::for_beats<1500>{});
  CHECK(heard.learning == cca::learning::collecting);
  const auto work = module.learning.begin_batch(module.p.settings);
  c.run(cca::for_beats<100>{});
  CHECK(heard.learning == cca::learning::batch);
  module.learning.hand_over(work());
  c.run(cca::for_beats<3000>{});
  CHECK(heard.learning == cca::learning::trained);
  CHECK(heard.region == cca::trained_region::inside);
  CHECK(heard.component == cca::component_status::reached);
  CHECK(heard.ode == cca::ode_status::transient);
  double lowest = 9, highest = -9;
  for (int k = 0; k < 1000; ++k) {
    c.step();
    lowest = std::min(lowest, c.get<"servo">().angles[0]),
    highest = std::max(highest, c.get<"servo">().angles[0]);
  }
  CHECK(highest - lowest == doctest::Approx(0.6).epsilon(0.05));
}

TEST_CASE("the picture of a tracker is the one on its page") { test::check_picture<pictured>(picture); }
