// EXPECT: space\.mismatch: `legs\.gait\.angles` \(exposed as `legs\.angles`\) publishes leg_angles \(joint_angles over hip, knee\) but `drive\.torques` expects leg_torques
// However the controller is used, only the graph's mistake is reported.
#include "parts.hpp"

// A diagnosis does not tell what else the compiler reports.

struct legs : cca::graph<cca::node<"cpg", oscillator>,
                         cca::node<"gait", gait>,
                         cca::wire<"cpg.phase", "gait.phase">,
                         cca::expose<"gait.angles", "angles">> {};

struct drive {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (int, pole_pairs));
  };
  parameters p{1, 7};
#if CCA_REJECT
  void process(cca::in<"torques", leg_torques>) {}
#else
  void process(cca::in<"torques", leg_angles>) {}
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"legs", legs>,
                         cca::node<"drive", drive>,
                         cca::wire<"legs.angles", "drive.torques", cca::queue<4>>> {};

double walked(cca::controller<walk>& c) {
  c.load();
  c.start();
  c.set<"drive">({2, 7});
  c.set<"drive">(drive::parameters{3, 7});
  c.run(cca::for_beats<10>{}, cca::as_fast_as_possible{},
        [](auto& running) { running.template get<"drive">().p.gain *= 2; });
  const auto snapshot = c;
  snapshot.for_each_component([](std::string_view, const auto&) {});
  c.for_each_component([](std::string_view, auto&) {});
  c.observed([](const cca::observation&) {});
  (void)c.get<"legs">().get<"gait">();
  while (c.step() && c.fault_path().empty() && !c.fault() && c.state() != cca::state::faulted) {}
  c = snapshot;
  (void)(c.dropped() + c.dropped<"drive.torques">() + c.dropped("drive.torques"));
  return c.get<"drive">().p.gain * static_cast<double>(c.beat_index() * cca::controller<walk>::period());
}
