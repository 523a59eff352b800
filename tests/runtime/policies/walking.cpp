// An imported policy in a graph: what the network sees, what is commanded, what is noticed.
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include <cca/mapping/imported/policy_servo.hpp>

#include "walker.hpp"

#include "written/walk.hpp"

namespace laws {
std::size_t allocations();
}  // namespace laws

namespace {

using namespace policies;

// A robot that says what the test says, and keeps what it is told.
struct bench {
  auto sense() -> std::tuple<cca::maybe<"rates", gyro>,
                             cca::maybe<"attitude", walker::attitude>,
                             cca::maybe<"command", command>,
                             cca::maybe<"angles", walker::angles>,
                             cca::maybe<"velocities", walker::velocities>> {
    std::tuple<cca::maybe<"rates", gyro>, cca::maybe<"attitude", walker::attitude>,
               cca::maybe<"command", command>, cca::maybe<"angles", walker::angles>,
               cca::maybe<"velocities", walker::velocities>>
        said;
    if (!says) return said;
    if (says_rates) std::get<0>(said) = rates;
    std::get<1>(said) = turned;
    std::get<2>(said) = wish;
    std::get<3>(said) = q;
    std::get<4>(said) = dq;
    return said;
  }
  void act(cca::optional_in<"torques", walker::torques> t) { felt = t.vector(); }

  bool says = true, says_rates = true;
  Eigen::Vector3d rates{0.1, -0.2, 0.3};
  Eigen::Vector4d turned{0.1, 0.2, 0.3, 0.927};  // x y z w
  Eigen::Vector2d wish{0.25, 0.5};               // turning, forward
  Eigen::Vector4d q{-0.7, 0.9, 0.2, -0.3};       // right knee, left knee, left hip, right hip
  Eigen::Vector4d dq{1, 2, 3, 4};
  Eigen::Vector4d felt = Eigen::Vector4d::Zero();
};

struct sink {
  void process(cca::in<"target", walker::targets> t,
               cca::in<"status", cca::policy_status_port> s,
               cca::in<"term", cca::policy_term_port> n) {
    target = t.vector();
    fresh = t.fresh();
    status = s.is(cca::policy_status::usable)    ? cca::policy_status::usable
             : s.is(cca::policy_status::unseen)  ? cca::policy_status::unseen
             : s.is(cca::policy_status::stale)   ? cca::policy_status::stale
             : s.is(cca::policy_status::waiting) ? cca::policy_status::waiting
                                                 : cca::policy_status::unreadable;
    term = static_cast<int>(n.vector()[0]);
    ++count;
  }
  Eigen::Vector4d target = Eigen::Vector4d::Zero();
  cca::policy_status status{};
  int term = -2, count = 0;
  bool fresh = false;
};

template <class Contract>
struct graph : cca::graph<cca::rate<1000>,
                          cca::node<"policy", walker::walking<Contract>, cca::timed<20>>,
                          cca::node<"servo",
                                    cca::policy_servo<Contract,
                                                      walker::targets,
                                                      walker::angles,
                                                      walker::velocities,
                                                      walker::torques>,
                                    cca::timed<1>>,
                          cca::node<"sink", sink, cca::timed<20>>,
                          cca::node<"limits", cca::limiter<walker::torques>>,
                          cca::node<"robot", bench>,
                          cca::wire<"robot.rates", "policy.base_ang_vel", cca::latest>,
                          cca::wire<"robot.attitude", "policy.attitude", cca::latest>,
                          cca::wire<"robot.command", "policy.velocity_commands", cca::latest>,
                          cca::wire<"robot.angles", "policy.joint_pos_rel", cca::latest>,
                          cca::wire<"robot.velocities", "policy.joint_vel_rel", cca::latest>,
                          cca::wire<"policy.output", "servo.target", cca::latest>,
                          cca::wire<"robot.angles", "servo.angles">,
                          cca::wire<"robot.velocities", "servo.velocities">,
                          cca::wire<"servo.torques", "limits.command">,
                          cca::wire<"limits.safe", "robot.torques">,
                          cca::wire<"policy.output", "sink.target">,
                          cca::wire<"policy.status", "sink.status">,
                          cca::wire<"policy.term", "sink.term">> {};

template <class Contract>
auto started() {
  auto c = std::make_unique<cca::controller<graph<Contract>>>();
  c->template get<"policy">().read(std::string(CCA_WRITTEN "/walk.policy"));
  c->load();
  c->start();
  return c;
}

// The contract of walk/ once more, by hand and slowly: names stand for places.
struct by_hand {
  std::vector<std::array<double, 21>> past;  // oldest first
  std::array<double, 4> last{};              // left hip, left knee, right hip, right knee
  std::unique_ptr<walker::walking<walk::contract>> policy =
      std::make_unique<walker::walking<walk::contract>>();

  by_hand() { policy->read(std::string(CCA_WRITTEN "/walk.policy")); }

  std::array<double, 21> observed(const bench& b) const {
    return {0.2 * std::clamp(b.rates[0], -100.0, 100.0),
            0.2 * std::clamp(b.rates[1], -100.0, 100.0),
            0.2 * std::clamp(b.rates[2], -100.0, 100.0),
            b.turned[3],
            b.turned[0],
            b.turned[1],
            b.turned[2],
            b.wish[1],
            b.wish[0],
            b.q[2] - 0.1,
            -b.q[1] + 0.8,
            b.q[3] + 0.1,
            b.q[0] + 0.8,
            0.05 * b.dq[2],
            -0.05 * b.dq[1],
            0.05 * b.dq[3],
            0.05 * b.dq[0],
            last[0],
            last[1],
            last[2],
            last[3]};
  }
  Eigen::Vector4d step(const bench& b) {
    const std::array<double, 21> x = observed(b);
    if (past.empty()) past.assign(3, x);
    past.erase(past.begin());
    past.push_back(x);
    const std::array<std::size_t, 7> begin{0, 3, 7, 9, 13, 17, 21};
    cca::neural::numbers<float, 63> seen;
    int at = 0;
    for (std::size_t term = 0; term < 6; ++term)
      for (const auto& one : past)
        for (std::size_t i = begin[term]; i < begin[term + 1]; ++i) seen[at++] = static_cast<float>(one[i]);
    cca::neural::numbers<float, 0> memory;
    const auto a = walk::network::answer(policy->weights.data(), seen, memory);
    const std::array<double, 4> rest{0.1, -0.8, -0.1, -0.8};
    std::array<double, 4> target{};
    for (std::size_t i = 0; i < 4; ++i) {
      last[i] = static_cast<double>(a[static_cast<int>(i)]);
      target[i] = rest[i] + 0.25 * std::clamp(last[i], -3.0, 3.0);
    }
    return {std::clamp(target[3], -2.5, 0.0), std::clamp(-target[1], 0.0, 2.5),
            std::clamp(target[0], -1.0, 1.0), std::clamp(target[2], -1.0, 1.0)};
  }
};

}  // namespace

TEST_CASE("an imported policy observes and commands what its contract says, in the robot's order of joints") {
  const auto c = started<walk::contract>();
  by_hand judge;
  bench& robot = c->get<"robot">();
  for (int k = 0; k < 1000; ++k) {
    for (int i = 0; i < 3; ++i) robot.rates[i] = (k == 500 ? 3000 : 2) * std::sin(0.3 * k + i);
    for (int i = 0; i < 4; ++i)
      robot.q[i] += 0.02 * std::sin(0.7 * k + i), robot.dq[i] = std::cos(0.7 * k + i);
    robot.wish = {std::sin(0.01 * k), std::cos(0.01 * k)};
    robot.turned = Eigen::Vector4d(std::sin(0.1 * k), 0.2, -0.3, std::cos(0.1 * k)).normalized();
    const Eigen::Vector4d wanted = judge.step(robot);
    c->step();
    const sink& told = c->get<"sink">();
    REQUIRE(told.status == cca::policy_status::usable);
    REQUIRE(told.term == -1);
    REQUIRE((told.target - wanted).norm() < 1e-6);
    const Eigen::Vector4d torque = (25 * (wanted - robot.q) - 0.5 * robot.dq).cwiseMax(-30).cwiseMin(30);
    REQUIRE((robot.felt - torque).norm() < 1e-4);
    for (int i = 1; i < 20; ++i) c->step();  // the servo goes on
  }
  CHECK(c->get<"sink">().count == 1000);
}

TEST_CASE("what a policy can't use is noticed, with the name of the term") {
  const auto c = started<walk::contract>();
  bench& robot = c->get<"robot">();
  const sink& told = c->get<"sink">();
  using policy = walker::walking<walk::contract>;
  const auto period = [&] {
    for (int i = 0; i < 20; ++i) c->step();
  };

  robot.says_rates = false;
  period();
  CHECK(told.status == cca::policy_status::waiting);
  CHECK(policy::term_name(told.term) == "base_ang_vel");
  CHECK_FALSE(told.fresh);
  robot.says_rates = true;
  period();
  CHECK(told.status == cca::policy_status::usable);
  CHECK(policy::term_name(told.term).empty());

  robot.wish[0] = 1.5;
  period();
  CHECK(told.status == cca::policy_status::unseen);
  CHECK(policy::term_name(told.term) == "velocity_commands");
  CHECK(told.fresh);
  robot.wish[0] = 0;

  // While a number is not finite, nothing is published and nothing is remembered.
  auto twin = std::make_unique<std::remove_cvref_t<decltype(*c)>>(*c);
  robot.q[1] = std::numeric_limits<double>::quiet_NaN();
  period();
  CHECK(told.status == cca::policy_status::unreadable);
  CHECK(policy::term_name(told.term) == "joint_pos_rel");
  CHECK_FALSE(told.fresh);
  robot.q[1] = 0.9;
  period();
  for (int i = 0; i < 20; ++i) twin->step();
  CHECK(told.status == cca::policy_status::usable);
  CHECK(told.target == twin->get<"sink">().target);

  robot.says_rates = false;  // the others go on
  for (int i = 0; i < 5; ++i) period();
  CHECK(told.status == cca::policy_status::usable);
  period();
  CHECK(told.status == cca::policy_status::stale);
  CHECK(policy::term_name(told.term) == "base_ang_vel");
}

TEST_CASE("a second start begins anew, and a beat allocates nothing") {
  const auto c = started<walk::contract>();
  c->step();
  const Eigen::Vector4d first = c->get<"sink">().target;
  for (int i = 0; i < 200; ++i) c->step();
  CHECK(c->get<"sink">().target != first);
  const auto before = laws::allocations();
  for (int i = 0; i < 200; ++i) c->step();
  CHECK(laws::allocations() == before);
  c->stop();
  c->start();
  for (int i = 0; i < 20; ++i) c->step();  // it fires once
  CHECK(c->get<"sink">().target == first);
}

TEST_CASE("a policy without weights is refused on load") {
  auto policy = std::make_unique<walker::walking<walk::contract>>();
  CHECK_THROWS_WITH(
      policy->on_load(),
      "cca::imported_policy: it has no weights; name the file that cca-policy wrote beside its header in the "
      "parameter `file`");
}

namespace {

// The same training, but for a history that began with zeros.
struct from_zeros : walk::contract {
  static constexpr cca::history_start start = cca::history_start::zero;
};
struct taking_over : cca::imported_policy<from_zeros,
                                          cca::policy_inputs<cca::in<"joint_vel_rel", walker::velocities>,
                                                             cca::in<"base_ang_vel", gyro>,
                                                             cca::in<"attitude", walker::attitude>,
                                                             cca::in<"joint_pos_rel", walker::angles>,
                                                             cca::in<"velocity_commands", command>,
                                                             cca::optional_in<"applied", walker::angles>>,
                                          walker::targets> {};
// The targets that the robot follows when the policy begins.
struct follows {
  auto process(cca::beat) -> cca::maybe<"applied", walker::angles> {
    if (!says) return {};
    return Eigen::Vector4d(-0.5, 0.6, 0.4, -0.2);  // right knee, left knee bend, left hip, right hip
  }
  bool says = true;
};
struct begun : cca::graph<cca::rate<50>,
                          cca::node<"robot", bench>,
                          cca::node<"follows", follows>,
                          cca::node<"policy", taking_over, cca::timed<1>>,
                          cca::node<"sink", sink, cca::timed<1>>,
                          cca::wire<"follows.applied", "policy.applied">,
                          cca::wire<"robot.rates", "policy.base_ang_vel">,
                          cca::wire<"robot.attitude", "policy.attitude">,
                          cca::wire<"robot.command", "policy.velocity_commands">,
                          cca::wire<"robot.angles", "policy.joint_pos_rel">,
                          cca::wire<"robot.velocities", "policy.joint_vel_rel">,
                          cca::wire<"policy.output", "sink.target">,
                          cca::wire<"policy.status", "sink.status">,
                          cca::wire<"policy.term", "sink.term">> {};

}  // namespace

TEST_CASE("a policy begins as its contract says, or in the middle of a motion where targets are applied") {
  for (const bool applied : {false, true}) {
    cca::controller<begun> c;
    c.get<"policy">().read(std::string(CCA_WRITTEN "/walk.policy"));
    c.load();
    c.get<"follows">().says = applied;
    c.start();
    by_hand judge;
    if (applied) {  // (sign target - rest) / scale, in the policy's order
      judge.last = {(0.4 - 0.1) / 0.25, (-0.6 + 0.8) / 0.25, (-0.2 + 0.1) / 0.25, (-0.5 + 0.8) / 0.25};
      judge.past.assign(3, judge.observed(c.get<"robot">()));
    } else {
      judge.past.assign(3, {});
    }
    for (int k = 0; k < 5; ++k) {
      const Eigen::Vector4d wanted = judge.step(c.get<"robot">());
      c.step();
      REQUIRE(c.get<"sink">().status == cca::policy_status::usable);
      CHECK((c.get<"sink">().target - wanted).norm() < 1e-6);
    }
  }
}
