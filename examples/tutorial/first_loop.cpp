// Tutorial, step 1: a first control loop. docs/tutorial/1_first_loop.md
// [program]
#include <cstdio>

#include <cca/cca.hpp>

// An axis with its limits. The compiler and the limiter read them.
struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}, cca::velocity{-2.0, 2.0}};
};

// What the wires carry: a domain type, its axes, its rate in Hz.
struct hip_angle : cca::space<cca::joint_angles, cca::axes<hip>, cca::rate<1000>> {};
struct hip_speed : cca::space<cca::joint_velocities, cca::axes<hip>, cca::rate<1000>> {};

// A proportional controller. The signature of `process` states its ports.
struct position_control {
  auto process(cca::in<"measured", hip_angle> angle) -> cca::out<"speed", hip_speed> {
    return 8.0 * (0.5 - angle[hip{}]);
  }
};

// The robot: a motor that turns exactly as fast as commanded.
struct motor {
  auto sense() -> cca::out<"angle", hip_angle> { return angle; }
  void act(cca::in<"speed", hip_speed> speed, cca::beat now) { angle += speed[hip{}] * now.dt(); }
  double angle = 0;
};

struct first_loop : cca::graph<cca::node<"motor", motor>,
                               cca::node<"control", position_control>,
                               cca::node<"limits", cca::limiter<hip_speed>>,
                               cca::wire<"motor.angle", "control.measured">,
                               cca::wire<"control.speed", "limits.command">,
                               cca::wire<"limits.safe", "motor.speed">> {};

int main() {
  cca::controller<first_loop> c;
  c.load();   // checks the parameters
  c.start();  // from here on it may run
  for (int i = 1; i <= 6; ++i) {
    c.run(cca::for_<0.1>{});  // 100 beats of 1 ms, as fast as the processor can
    std::printf("%.1f s  hip %.4f rad\n", 0.1 * i, c.get<"motor">().angle);
  }
}
// [program end]
