#pragma once
// A pole on a joint that a policy holds upright: the smallest task.
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <thread>
#include <tuple>

#include <cca/base/math/random_numbers.hpp>
#include <cca/cca.hpp>
#include <cca/mapping/policy.hpp>
#include <cca/python/score.hpp>
#include <cca/python/stand_in.hpp>
#include <cca/python/task.hpp>

namespace python_test {

struct joint : cca::dimension<"joint"> {
  static constexpr auto limits = cca::limits{cca::angle{-3, 3}, cca::velocity{-20, 20}, cca::torque{-2, 2}};
};
struct angle : cca::space<cca::joint_angles, cca::axes<joint>, cca::rate<100>> {};
struct velocity : cca::space<cca::joint_velocities, cca::axes<joint>, cca::rate<100>> {};
struct torque : cca::space<cca::joint_torques, cca::axes<joint>, cca::rate<100>> {};
struct slow_torque : cca::space<cca::joint_torques, cca::axes<joint>, cca::rate<25>> {};

struct balance : cca::policy<cca::policy_inputs<cca::in<"angle", angle>, cca::in<"velocity", velocity>>,
                             cca::hidden_layers<3>,
                             cca::hyperbolic_tangent,
                             slow_torque> {};

// The joint carries a pole: d2 angle = pull sin(angle) + torque.
struct pole {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0, 100>, pull),
                             (cca::bounded<double, 0, 100>, breaks_at));  // rad/s: a fault
  };
  parameters p{9.0, 50.0};

  auto sense() -> std::tuple<cca::out<"angle", angle>, cca::out<"velocity", velocity>> { return {at, speed}; }
  auto act(cca::in<"torque", torque> pushed) -> cca::fault {
    if (std::abs(speed) > p.breaks_at) return "the pole is too fast";
    speed += 0.01 * (p.pull * cca::math::sin(at) + pushed[joint{}]);
    at += 0.01 * speed;
    return {};
  }
  double at = 0, speed = 0;
};

// How far the pole is from upright, before each beat.
struct truth_axis : cca::dimension<"off"> {};
struct off : cca::space<cca::number, cca::axes<truth_axis>> {};
struct truth {
  auto process() -> cca::out<"off", off> { return now; }
  double now = 0;
};
struct judge {
  auto process(cca::in<"off", off> by)
      -> std::tuple<cca::out<"reward", cca::python::reward>, cca::out<"done", cca::python::done>> {
    return {1 - by[truth_axis{}], by[truth_axis{}] > 0.5 ? 1.0 : 0.0};
  }
};

template <class Policy>
struct balanced : cca::graph<cca::rate<100>,
                             cca::node<"policy", Policy, cca::timed<4>>,
                             cca::node<"hold", cca::hold<slow_torque, torque>, cca::timed<1>>,
                             cca::node<"limits", cca::limiter<torque>>,
                             cca::node<"pole", pole>,
                             cca::node<"truth", truth>,
                             cca::node<"judge", judge>,
                             cca::node<"score", cca::python::score>,
                             cca::wire<"pole.angle", "policy.angle", cca::latest>,
                             cca::wire<"pole.velocity", "policy.velocity", cca::latest>,
                             cca::wire<"policy.output", "hold.input", cca::latest>,
                             cca::wire<"hold.output", "limits.command">,
                             cca::wire<"limits.safe", "pole.torque">,
                             cca::wire<"truth.off", "judge.off">,
                             cca::wire<"judge.reward", "score.reward">,
                             cca::wire<"judge.done", "score.done">> {};

// The episode of this seed begins once Python says so; in ten seconds, or never.
inline std::atomic<bool> may_begin = false;
inline void wait_for_python() {
  for (int k = 0; k < 1000 && !may_begin; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  if (!may_begin) throw std::runtime_error("Python has not said that it may begin");
}

template <class Controller>
void begin_with(Controller& c, std::uint64_t seed) {
  if (seed == 50'000'000) throw std::runtime_error("there is no such pole");
  if (seed == 60'000'000) wait_for_python();
  cca::random_numbers random(seed);
  c.template get<"pole">().at = random.between(-0.2, 0.2);
  c.template get<"pole">().speed = random.between(-0.2, 0.2);
}
template <class Controller>
void look_at(Controller& c) {
  c.template get<"truth">().now = std::abs(c.template get<"pole">().at);
}

struct balancing : cca::python::task<balanced<cca::python::stand_in<balance>>> {
  static constexpr double seconds = 2;
  static void begin(controller& c, std::uint64_t seed) { begin_with(c, seed); }
  static void before_beat(controller& c) { look_at(c); }
};

}  // namespace python_test
