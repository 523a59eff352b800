// A leg that walks, and stands as soon as its foot loses the ground. Walking and standing are two
// architectures on one robot; the limiter that both have keeps the command from jumping.
// docs/modes.md
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <tuple>

#include <cca/cca.hpp>
#include <cca/main.hpp>
#include <cca/modes.hpp>

#if __has_include(<cca/record.hpp>)
#include <cca/record.hpp>                // offers --record
#include <cca/record/replay_option.hpp>  // offers --replay
#endif
#if __has_include(<cca/door.hpp>)
#include <cca/door.hpp>  // offers --door
#endif

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}, cca::velocity{-4.0, 4.0}};
};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip>, cca::rate<1000>> {};
struct load : cca::space<cca::number, cca::axes<cca::x>, cca::rate<1000>> {};  // on the foot in N

struct leg {  // stands for a robot: it reaches each command at once
  auto sense() -> std::tuple<cca::out<"angles", leg_angles>, cca::out<"load", load>> { return {at, on_foot}; }
  void act(cca::in<"command", leg_angles> to) {
    const double angle = to[hip{}];
    fastest = std::max(fastest, std::abs(angle - at) * 1000);
    at = angle;
  }
  double at = 0, on_foot = 40, fastest = 0;
};

// [components]
struct gait {
  auto process(cca::in<"load", load> on_foot, cca::beat now)
      -> std::tuple<cca::out<"angles", leg_angles>, cca::switch_to<"stand">> {
    phase += 6 * now.dt();
    return {0.5 * cca::math::sin(phase), on_foot[cca::x{}] < 5};  // true asks for the mode
  }
  double phase = 0;
};

struct stance {
  auto process(cca::in<"load", load> on_foot)
      -> std::tuple<cca::out<"angles", leg_angles>, cca::switch_to<"walk">> {
    beats = on_foot[cca::x{}] < 5 ? 0 : beats + 1;
    return {-0.2, beats > 300};
  }
  void on_start() { beats = 0; }  // whenever the mode begins
  int beats = 0;
};
// [components end]

// [modes]
struct walk : cca::graph<cca::node<"leg", leg>,
                         cca::node<"gait", gait>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
                         cca::wire<"leg.load", "gait.load">,
                         cca::wire<"gait.angles", "limits.command">,
                         cca::wire<"limits.safe", "leg.command">> {};

struct stand : cca::graph<cca::node<"leg", leg>,
                          cca::node<"stance", stance>,
                          cca::node<"limits", cca::limiter<leg_angles>>,
                          cca::wire<"leg.load", "stance.load">,
                          cca::wire<"stance.angles", "limits.command">,
                          cca::wire<"limits.safe", "leg.command">> {};

struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"stand", stand>>,
              cca::recordable,    // offers --record and --replay
              cca::traceable {};  // offers --trace
// [modes end]

// [program]
struct program : cca::robot_program<legs> {  // begins in the first mode
  program() {
    purpose = "a leg that walks, and stands when its foot loses the ground";
    settings.seconds = 1.6;
    settings.speed.reset();  // a fast run
  }

  bool between(controller_type& c) override {
    const std::int64_t beat = c.beat_index();
    if (beat == 800 || beat == 801 || beat == 1000 || beat == 1400 || beat == 1600) tell(c);
    if (beat == 800) c.get<"leg">().on_foot = 0;  // the ground is gone
    if (beat == 1000) c.get<"leg">().on_foot = 40;
    if (beat == 1400) c.switch_to<"stand">();  // from outside, between two beats
    return true;
  }
  // [program end]

  int finish(controller_type& c) override {
    std::printf("the command moved at most at %.2f rad/s\n", c.get<"leg">().fastest);
    return 0;
  }

  void tell(const controller_type& c) const {
    const std::string mode(c.mode());
    std::printf("beat %4lld: %-5s hip %6.3f rad\n", static_cast<long long>(c.beat_index()), mode.c_str(),
                c.get<"leg">().at);
  }
};

int main(int count, char** words) { return cca::robot_main<program>(count, words); }
