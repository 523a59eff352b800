// The example of section 6.3 of the source document: a component listens to the superscope `/example/dmp`,
// and gets all data of the DMP Transformation System.
#include <map>
#include <set>
#include <string>

#include <cca/adaptive/adaptive_component.hpp>
#include <cca/adaptive/tracking.hpp>
#include <cca/motor/dmp_rhythmic_module.hpp>
#include <cca/motor/hopf.hpp>

#include "rig.hpp"

using namespace adaptive_test;

namespace {

struct reaching_controller {  // stands for the Reaching Controller of the document
  auto process(cca::beat)
      -> std::tuple<cca::out<"angles", leg>, cca::out<"amplitude", cca::over<cca::amplitude, stride>>> {
    return {Eigen::Vector2d(0.1, -0.8), 1.0};
  }
};
struct joints {
  auto process(cca::in<"command", leg> wanted) -> cca::out<"angles", leg> {
    return angles += 0.2 * (wanted.vector() - angles);
  }
  Eigen::Vector2d angles{0, 0};
};

// [superscope]
struct dmp : cca::tracker<cca::dmp_rhythmic_module<leg, stride, 25>, cca::tracking<leg>> {};

struct example : cca::graph<cca::node<"reaching", reaching_controller>,
                            cca::node<"hopf", cca::hopf<stride>, cca::timed<1>>,
                            cca::node<"dmp", dmp>,
                            cca::wire<"reaching.amplitude", "hopf.amplitude">,
                            cca::wire<"hopf.phase", "dmp.phase">,
                            cca::wire<"hopf.amplitude", "dmp.amplitude">,
                            cca::wire<"reaching.angles", "dmp.reference">,
                            cca::expose<"dmp.command", "command">,
                            cca::expose<"dmp.feedback", "feedback">> {};

struct everything {  // all data of the component: what goes in, what comes out, its statuses
  void process(cca::observe<"/example.dmp.**"> all) {
    for (const cca::observation& one : all) {
      paths.emplace(one.path);
      if (const auto* angles = one.as<leg>(); angles && angles->origin() != cca::never)
        newest[std::string(one.path)] = angles->vector();
    }
  }
  std::set<std::string> paths;
  std::map<std::string, Eigen::Vector2d> newest;
};
struct statuses {  // the entire, accumulated status
  void process(cca::observe<"/example.dmp.status.*"> all) {
    count = all.size();
    component = static_cast<cca::component_status>(all.find("example.dmp.status.component")->values[0]);
  }
  std::size_t count = 0;
  cca::component_status component{};
};
struct listeners : cca::graph<cca::node<"all", everything>, cca::node<"status", statuses>> {};

struct prototype : cca::graph<cca::rate<1000>,
                              cca::node<"example", example>,
                              cca::node<"joints", joints>,
                              cca::node<"listeners", listeners>,
                              cca::wire<"example.command", "joints.command">,
                              cca::wire<"joints.angles", "example.feedback", cca::delayed<1>>> {};
// [superscope end]

}  // namespace

TEST_CASE("who listens to the superscope of a component gets all of its data") {
  cca::controller<prototype> c;
  c.load();
  c.start();
  c.run(cca::for_beats<3000>{});
  const auto& all = c.get<"listeners.all">();
  // The seven ports of figure 6.3, under the names that they have here, and what stands between them.
  for (const char* path : {"example.dmp.module.phase",        // 1. phase input
                           "example.dmp.module.reference",    // 2. joint angle command input
                           "example.dmp.criterion.feedback",  // 3. joint angle feedback
                           "example.dmp.module.command",      // 4. joint angle command output
                           "example.dmp.status.ode",          // 5. ODE status
                           "example.dmp.status.module",       // 6. adaptive module status
                           "example.dmp.status.component",    // 7. adaptive component status
                           "example.dmp.criterion.error", "example.dmp.criterion.state"})
    CHECK_MESSAGE(all.paths.contains(path), path);
  for (const auto& path : all.paths) CHECK(path.starts_with("example.dmp."));
  CHECK(all.newest.at("example.dmp.module.reference") == Eigen::Vector2d(0.1, -0.8));
  CHECK(all.newest.at("example.dmp.criterion.feedback") != Eigen::Vector2d(0, 0));
  CHECK(c.get<"listeners.status">().count == 3);
  CHECK(c.get<"listeners.status">().component == cca::component_status::reached);
}
