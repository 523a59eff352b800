// An adaptive mapping learns the inverse kinematics of Oncilla's leg from its forward kinematics, and is
// compared with the analytic one. An adaptive transformation corrects a camera.
#include <array>
#include <string_view>

#include <cca/adaptive/extreme_learning_machine.hpp>
#include <cca/adaptive/sampling.hpp>
#include <cca/mapping/adaptive_mapping.hpp>
#include <cca/mapping/forward_kinematics.hpp>
#include <cca/mapping/mapping_chain.hpp>

#include "../../laws/learner_laws.hpp"
#include "../../laws/mapping_laws.hpp"
#include "../../laws/request_laws.hpp"
#include "../mapping/chains.hpp"
#include "../picture.hpp"
#include "rig.hpp"

namespace {

using namespace mapping_test;

// [adaptive mapping]
struct angles : cca::space<cca::joint_angles, cca::axes<hip_joint, knee>> {};
struct paw : cca::space<cca::cartesian_position<mapping_test::hip>, cca::axes<cca::x, cca::z>> {};
using machine = cca::extreme_learning_machine<cca::elm_function<paw, angles, 120>>;

using learned_ik =
    cca::adaptive_mapping<paw, angles, machine, 2000>;  // in "input", "teacher"; out "output", "module"
using analytic_ik =
    cca::inverse_kinematics<leg_in_plane, angles, paw>;  // in "position"; out "angles", "status"
using forward = cca::forward_kinematics<leg_in_plane, angles, paw>;
// [adaptive mapping end]

// Angles within the limits, with the knee bent one way.
Eigen::Vector2d posture(laws::ode_source& random) {
  constexpr auto hip_range = oncilla.hip_range, knee_range = oncilla.knee_range;
  const double low = knee_range.low + 0.1 * (knee_range.high - knee_range.low),
               high = knee_range.low + 0.8 * (knee_range.high - knee_range.low);
  return {random(0.9 * hip_range.low, 0.9 * hip_range.high), random(low, high)};
}

struct ik_case {
  using learner = machine;
  static constexpr double left = 0.01;
  static Eigen::Vector2d input(laws::ode_source& random) {
    forward there;
    return laws::map(there, posture(random));
  }
  static Eigen::Vector2d truth(const Eigen::Vector2d& p) {
    analytic_ik back;
    return laws::map(back, p);
  }
  static Eigen::Vector2d far() { return {0.5, 0.5}; }
};

struct here : cca::space<cca::number, cca::axes<cca::x, cca::y>> {};

// For the laws of requests.
template <class Mapping, class Case>
struct taught_mapping {
  using student = Mapping;
  static constexpr auto numbers = laws::any_numbers;
  static auto fresh() { return std::make_unique<student>(); }
  static laws::told_of_request fire(student& s, double call, bool) { return process(s, 0, call, false); }
  static void teach(student& s) {
    for (int k = 0; k < 100; ++k) (void)process(s, k, 0, true);
  }

private:
  static laws::told_of_request process(student& s, int k, double call, bool is_shown) {
    static const auto all = laws::examples<Case>(100, 7);
    const auto& one = all[static_cast<std::size_t>(k)];
    using ports = cca::detail::function_facts<decltype(&student::process)>;
    return [&]<class In, class Teacher, class Call>(cca::detail::list<In, Teacher, Call>) {
      Teacher teacher(one.y, k, is_shown);
      teacher.set_wired();
      const auto [output, status] = s.process(In(one.x, k, true), teacher, laws::numbered_request(call));
      return laws::told_of(status.vector());
    }(typename ports::parameters{});
  }
};
struct correction_case {
  using learner = cca::extreme_learning_machine<cca::elm_function<here, here, 40>>;
  static Eigen::Vector2d input(laws::ode_source& random) { return {random(-1, 1), random(-1, 1)}; }
  static Eigen::Vector2d truth(const Eigen::Vector2d& x) { return {x[0] + 0.1 * x[1] * x[1], 0.9 * x[1]}; }
};

}  // namespace

TEST_CASE("learned inverse kinematics obey the laws of a learner") { laws::learner<ik_case>(); }

TEST_CASE("an adaptive mapping and a transformation answer every request") {
  laws::requests<laws::lone_learner<ik_case>>();
  laws::requests<taught_mapping<learned_ik, ik_case>>();
  laws::requests<
      taught_mapping<cca::adaptive_transformation<here, correction_case::learner>, correction_case>>();
}

TEST_CASE("learned inverse kinematics agree with the analytic ones to two milliradians") {
  static_assert(cca::Mapping<learned_ik> && cca::SameSpace<cca::output_space<learned_ik>, angles>);
  const auto ik = std::make_unique<learned_ik>();
  analytic_ik exact;
  forward there;
  laws::ode_source random{std::mt19937_64{21}};
  using input = cca::in<"input", paw>;
  using teacher = cca::optional_in<"teacher", angles>;
  ik->learning.collect();
  for (int k = 0; k < 2000; ++k) {
    const Eigen::Vector2d q = posture(random);
    teacher t(q, k, true);
    t.set_wired();
    (void)ik->process(input(laws::map(there, q), k, true), t, {});
  }
  CHECK(ik->learning.example_count() == 2000);
  ik->learning.hand_over(ik->learning.begin_batch(ik->p.settings)());
  double square = 0, worst = 0, furthest = 0;
  for (int k = 0; k < 2000; ++k) {
    const Eigen::Vector2d posed = posture(random), p = laws::map(there, posed);
    cca::optional_in<"near", angles> near(posed, k,
                                          true);  // of the two solutions the one with the knee bent this way
    near.set_wired();
    const auto [solved, reached] = exact.process(cca::in<"position", paw>(p, k, true), near);
    const auto [q, status] = ik->process(input(p, k, true), {}, {});
    const double off = (q.vector() - solved.vector()).cwiseAbs().maxCoeff();
    square += off * off, worst = std::max(worst, off);
    furthest = std::max(furthest, (laws::map(there, q.vector()) - p).norm());
  }
  MESSAGE("angles: rms " << std::sqrt(square / 2000) << " rad, at most " << worst << " rad; paw: at most "
                         << 1000 * furthest << " mm");
  CHECK(std::sqrt(square / 2000) < 2e-3);
  CHECK(worst < 0.03);
  CHECK(furthest < 0.003);
  const auto [q, status] = ik->process(input(Eigen::Vector2d(0.0, 0.3), 0, true), {}, {});
  CHECK(q.vector().allFinite());
  CHECK(status.vector()[1] == cca::status_of(cca::trained_region::outside));
}

TEST_CASE("a learner can choose the postures for learning inverse kinematics") {
  const auto ik = std::make_unique<learned_ik>();
  forward there;
  const Eigen::Vector2d low(
      0.9 * oncilla.hip_range.low,
      oncilla.knee_range.low + 0.1 * (oncilla.knee_range.high - oncilla.knee_range.low));
  const Eigen::Vector2d high(
      0.9 * oncilla.hip_range.high,
      oncilla.knee_range.low + 0.8 * (oncilla.knee_range.high - oncilla.knee_range.low));
  const auto ask = [&](const Eigen::Vector2d& q) {
    return cca::example<machine::model>{laws::map(there, q), q};
  };
  CHECK_THROWS_WITH_AS(cca::sample_examples(ik->learning, low, high, 10, ik->p.settings, ask),
                       "cca::sample_examples: refused while it is `idle`: collect() or learn() first",
                       cca::refused);
  // [sampling]
  ik->learning.collect();
  cca::sample_examples(ik->learning, low, high, 1000, ik->p.settings,
                       ask);  // for each posture the position of the paw
  ik->learning.hand_over(ik->learning.begin_batch(ik->p.settings)());
  // [sampling end]
  laws::ode_source random{std::mt19937_64{23}};
  double square = 0;
  for (int k = 0; k < 1000; ++k) {
    const Eigen::Vector2d q = posture(random), p = laws::map(there, q);
    CHECK(ik->learning.in_trained_region(p, ik->p.settings));
    square += (ik->learning.answer(p) - q).squaredNorm() / 2;
  }
  CHECK(std::sqrt(square / 1000) < 2e-3);
  CHECK_FALSE(ik->learning.in_trained_region({0.5, 0.5}, ik->p.settings));
}

TEST_CASE("spread points cover a box evenly, in any number") {
  const Eigen::Vector3d low(-1, 0, 10), high(1, 0.5, 20);
  for (const int count : {64, 500}) {
    std::array<int, 8> octants{};
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector3d p = cca::spread_point(low, high, i), u = (p - low).cwiseQuotient(high - low);
      CHECK((u.minCoeff() >= 0 && u.maxCoeff() < 1));
      ++octants[static_cast<std::size_t>((u[0] < 0.5) + 2 * (u[1] < 0.5) + 4 * (u[2] < 0.5))];
    }
    for (const int in_octant : octants) CHECK(std::abs(in_octant - count / 8.0) <= 4);
  }
  CHECK(cca::spread_point(low, high, 0) == Eigen::Vector3d(0, 0.5 / 3, 12));  // 1/2, 1/3 and 1/5 of the way
}

namespace {

// A leg that moves through postures while a camera observes its paw; it requests learning through a port.
struct led_leg {
  auto process(cca::beat now) -> std::
      tuple<cca::out<"paw", paw>, cca::out<"angles", angles>, cca::out<"learn", cca::learning_request>> {
    const Eigen::Vector2d q =
        cca::spread_point(Eigen::Vector2d(-0.5, -1.4), Eigen::Vector2d(0.5, -0.6), now.index());
    forward there;
    return {laws::map(there, q), q,
            cca::status_of(now.index() == 0 ? cca::learning_call::collect : cca::learning_call::nothing)};
  }
};
struct heard {
  void process(cca::in<"angles", angles> q, cca::in<"module", cca::module_status_port> s) {
    answer = q.vector(), learning = s.vector()[0];
  }
  Eigen::Vector2d answer{0, 0};
  double learning = -1;
};
struct taught : cca::graph<cca::rate<1000>,
                           cca::node<"leg", led_leg>,
                           cca::node<"ik", learned_ik>,
                           cca::node<"ear", heard>,
                           cca::wire<"leg.paw", "ik.input">,
                           cca::wire<"leg.angles", "ik.teacher">,
                           cca::wire<"leg.learn", "ik.learn">,
                           cca::wire<"ik.output", "ear.angles">,
                           cca::wire<"ik.module", "ear.module">> {};

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  n0["leg<br/><i>1000 Hz</i>"]
  n1["ik<br/><i>1000 Hz</i>"]
  n2["ear<br/><i>1000 Hz</i>"]
  n0 -- "paw → input<br/>paw, 1000 Hz" --> n1
  n0 -- "angles → teacher<br/>angles, 1000 Hz" --> n1
  n0 -- "learn<br/>learning_request, 1000 Hz" --> n1
  n1 -- "output → angles<br/>angles, 1000 Hz" --> n2
  n1 -- "module<br/>module_status_port, 1000 Hz" --> n2
)";  // [picture end]

}  // namespace

TEST_CASE("the picture of a taught mapping is the one on its page") { test::check_picture<taught>(picture); }

TEST_CASE("an adaptive mapping learns in a graph and keeps the result in a file") {
  const auto first = std::make_unique<cca::controller<taught>>(),
             second = std::make_unique<cca::controller<taught>>();
  const adaptive_test::temporary file("inverse_kinematics");
  for (auto* c : {first.get(), second.get()}) {
    auto& files = c->get<"ik">().p.files;
    REQUIRE((c == first.get() ? files.save : files.load).assign(file.path));
  }
  first->load();
  first->start();
  first->run(cca::for_beats<1000>{});
  CHECK(first->get<"ear">().learning == cca::status_of(cca::learning::collecting));
  auto& module = first->get<"ik">();
  module.learning.hand_over(module.learning.begin_batch(module.p.settings)());
  first->run(cca::for_beats<1>{});
  CHECK(first->get<"ear">().learning == cca::status_of(cca::learning::trained));
  first->stop();
  first->save();
  second->load();
  second->start();
  double square = 0;
  for (int k = 0; k < 1000; ++k) {
    second->step();
    // The answer reaches the target, and equals that of the first mapping bit for bit.
    const Eigen::Vector2d wanted =
        cca::spread_point(Eigen::Vector2d(-0.5, -1.4), Eigen::Vector2d(0.5, -0.6), k);
    forward there;
    square += (second->get<"ear">().answer - wanted).squaredNorm() / 2;
    CHECK(second->get<"ear">().answer == module.learning.answer(laws::map(there, wanted)));
  }
  CHECK(std::sqrt(square / 1000) < 2e-3);
}

TEST_CASE("an adaptive transformation changes nothing until it has learned a correction") {
  using correction =
      cca::adaptive_transformation<here, cca::extreme_learning_machine<cca::elm_function<here, here, 40>>>;
  static_assert(cca::Transformation<correction>);
  correction c;
  const auto bent = [](const Eigen::Vector2d& v) {
    return Eigen::Vector2d(v[0] + 0.1 * v[1] * v[1], 0.9 * v[1] - 0.05);
  };
  using input = cca::in<"input", here>;
  using teacher = cca::optional_in<"teacher", here>;
  CHECK(std::get<0>(c.process(input(Eigen::Vector2d(0.3, 0.4), 0, true), {}, {})).vector() ==
        Eigen::Vector2d(0.3, 0.4));
  laws::ode_source random{std::mt19937_64{22}};
  c.learning.collect();
  for (int k = 0; k < 500; ++k) {
    const Eigen::Vector2d v(random(-1, 1), random(-1, 1));
    teacher t(bent(v), k, true);
    t.set_wired();
    (void)c.process(input(v, k, true), t, {});
  }
  c.learning.hand_over(c.learning.begin_batch(c.p.settings)());
  for (int k = 0; k < 100; ++k) {
    const Eigen::Vector2d v(random(-1, 1), random(-1, 1));
    CHECK((std::get<0>(c.process(input(v, k, true), {}, {})).vector() - bent(v)).norm() < 2e-3);
  }
}
