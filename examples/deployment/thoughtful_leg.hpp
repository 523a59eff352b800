// A leg with a reflex, and a component that computes for 8 ms while beats last 1 ms: the architecture of the
// examples in this folder, and how it is spread over two environments.
#pragma once

#include <chrono>

#include <cca/cca.hpp>
#include <cca/deployment.hpp>

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
};
struct hip_angle : cca::space<cca::joint_angles, cca::axes<hip>> {};

struct leg {  // stands for a robot: it comes a tenth nearer to its command in each beat
  auto sense() -> cca::out<"angle", hip_angle> { return angle; }
  void act(cca::in<"command", hip_angle> to) { angle += 0.1 * (to[hip{}] - angle); }
  double angle = 0;
};

struct reflex {
  auto process(cca::in<"angle", hip_angle> is, cca::in<"plan", hip_angle> plan)
      -> cca::out<"command", hip_angle> {
    return is[hip{}] + 0.5 * (plan[hip{}] - is[hip{}]);
  }
};

// [component]
struct thinker {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, step), (int, milliseconds));
  };
  parameters p{0.25, 8};

  // Takes long, but its result depends on its inputs alone.
  auto process(cca::in<"angle", hip_angle> is, cca::beat now) -> cca::out<"plan", hip_angle> {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(p.milliseconds);
    const double plan = p.step * cca::math::sin(static_cast<double>(now.index()) + 3 * is[hip{}]);
    while (std::chrono::steady_clock::now() < end) {}
    return plan;
  }
};
// [component end]

// [architecture]
struct thoughtful_leg : cca::graph<cca::rate<1000>,
                                   cca::node<"leg", leg>,
                                   cca::node<"reflex", reflex>,
                                   cca::node<"limits", cca::limiter<hip_angle>>,
                                   cca::node<"thinker", thinker, cca::timed<10>>,
                                   cca::wire<"leg.angle", "reflex.angle">,
                                   cca::wire<"reflex.command", "limits.command">,
                                   cca::wire<"limits.safe", "leg.command">,
                                   cca::wire<"leg.angle", "thinker.angle", cca::delayed<1>>,
                                   cca::wire<"thinker.plan", "reflex.plan", cca::delayed<10>>> {
};  // 10 beats to think
// [architecture end]

// [deployment]
struct split : cca::deployment<thoughtful_leg,
                               cca::environment<"robot", cca::nodes<"leg", "reflex", "limits">>,
                               cca::environment<"mind", cca::other_nodes>,
                               cca::tolerate<100>>,
               cca::recordable,    // offers --record, where <cca/record.hpp> is included
               cca::traceable {};  // offers --trace
// [deployment end]
