// Bounds that follow from the rate of the node: each component of motor/ that has one is refused at 10 Hz
// with the parameter, the bound and the rate, on load and on a change; a faster node takes the same number.
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/motor.hpp>

namespace {

struct stride : cca::dimension<"stride"> {};
struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct lf : cca::dimension<"left_front"> {};
struct rf : cca::dimension<"right_front"> {};
struct lh : cca::dimension<"left_hind"> {};
struct rh : cca::dimension<"right_hind"> {};
struct trunk : cca::frame<"trunk"> {};
struct hand : cca::frame<"hand"> {};
struct leg : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
struct hand_in_trunk : cca::space<cca::pose<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};

template <class Space>
struct constant {
  auto process(cca::beat) -> cca::out<"value", Space> { return cca::sample<Space>{}.vector(); }
};

using network = cca::gait_network<lf, rf, lh, rh>;
template <class Component, cca::fixed_string Name, class Space, int Every>
struct fed : cca::graph<cca::rate<1000>,
                        cca::node<"source", constant<Space>>,
                        cca::node<"node", Component, cca::timed<Every>>,
                        cca::wire<"source.value", Name, cca::latest>> {};

template <int Every>
struct vite : fed<cca::vite<leg>, "node.target", leg, Every> {};
template <int Every>
struct gait_network : fed<network, "node.amplitude", network::legs<cca::amplitude>, Every> {};
template <int Every>
struct dmp_discrete : fed<cca::dmp_discrete<leg, 5>, "node.goal", leg, Every> {};
template <int Every>
struct dmp_pose : fed<cca::dmp_pose<hand_in_trunk, hand, 3>, "node.goal", hand_in_trunk, Every> {};

template <class Component, cca::fixed_string Centre, int Every>
struct rhythmic : cca::graph<cca::rate<1000>,
                             cca::node<"phase", constant<cca::over<cca::phase, stride>>>,
                             cca::node<"amplitude", constant<cca::over<cca::amplitude, stride>>>,
                             cca::node<"centre", constant<leg>>,
                             cca::node<"node", Component, cca::timed<Every>>,
                             cca::wire<"phase.value", "node.phase", cca::latest>,
                             cca::wire<"amplitude.value", "node.amplitude", cca::latest>,
                             cca::wire<"centre.value", Centre, cca::latest>> {};
template <int Every>
struct dmp_rhythmic : rhythmic<cca::dmp_rhythmic<leg, stride, 5>, "node.goal", Every> {};
template <int Every>
struct dmp_rhythmic_module : rhythmic<cca::dmp_rhythmic_module<leg, stride, 5>, "node.reference", Every> {};

template <class F>
std::string words_of(F f) {
  try {
    f();
  } catch (const cca::refused& refusal) { return refusal.what(); }
  return {};
}

struct row {
  const char* component;
  std::string refused, on_load, on_change, at_100_hz;  // what is refused; the three answers
  bool is_kept;                                        // the number before is kept
};

// `member` is set to `value`, which a node of 10 Hz can't follow, and one of 100 Hz can.
template <template <int> class Graph, class Member>
row tried(const char* name, Member member, double value, const std::string& refused) {
  row r{name, refused, {}, {}, {}, false};
  cca::controller<Graph<100>> slow, changed;
  member(slow.template get<"node">().p) = value;
  r.on_load = words_of([&] { slow.load(); });
  changed.load();
  auto wanted = changed.template get<"node">().p;
  const double before = member(wanted);
  member(wanted) = value;
  r.on_change = words_of([&] { changed.template set<"node">(wanted); });
  r.is_kept = member(changed.template get<"node">().p) == before;
  cca::controller<Graph<10>> fast;
  member(fast.template get<"node">().p) = value;
  r.at_100_hz = words_of([&] { fast.load(); });
  return r;
}

}  // namespace

// At 10 Hz a component can follow a rate of 160/s: 16 parts of a beat.
TEST_CASE("each bound that follows from the rate is checked on load and on changes, and named") {
  const std::vector<row> rows{
      tried<vite>(
          "vite", [](auto& p) -> auto& { return p.convergence; }, 200,
          "`convergence` is 200, but at 10 Hz it must be at most 160"),
      tried<vite>(
          "vite", [](auto& p) -> auto& { return p.speed; }, 900,  // 160^2 / 30
          "`speed` is 900, but at 10 Hz it must be at most 853.333"),
      tried<gait_network>(
          "gait_network", [](auto& p) -> auto& { return p.coupling; }, 50,
          "`coupling` is 50, but at 10 Hz it must be at most 40"),
      tried<gait_network>(
          "gait_network", [](auto& p) -> auto& { return p.convergence; }, 400,
          "`convergence` is 400, but at 10 Hz it must be at most 320"),
      tried<dmp_discrete>(
          "dmp_discrete", [](auto& p) -> auto& { return p.duration; }, 0.05,  // 12.5 / 160
          "`duration` is 0.05, but at 10 Hz it must be at least 0.078125"),
      tried<dmp_pose>(
          "dmp_pose", [](auto& p) -> auto& { return p.duration; }, 0.05,
          "`duration` is 0.05, but at 10 Hz it must be at least 0.078125"),
      tried<dmp_rhythmic>(
          "dmp_rhythmic", [](auto& p) -> auto& { return p.frequency; }, 5,  // 160 / (2 pi 12.5)
          "`frequency` is 5, but at 10 Hz it must be at most 2.03718"),
      tried<dmp_rhythmic_module>(
          "dmp_rhythmic_module", [](auto& p) -> auto& { return p.frequency; }, 5,
          "`frequency` is 5, but at 10 Hz it must be at most 2.03718")};
  for (const row& r : rows) {
    CAPTURE(r.component);
    const std::string words = "node: " + r.refused + ": run the node faster, or change it";
    CHECK(r.on_load.find(words) != std::string::npos);
    CHECK(r.on_change == words);
    CHECK(r.is_kept);
    CHECK(r.at_100_hz == "");
  }
}
