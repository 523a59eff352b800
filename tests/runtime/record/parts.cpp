// A recording has the parts that stop and start, asked for from outside and by components, and is replayed
// with them bit for bit: of one loop, of environments and of modes.
#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include <cca/deployment.hpp>
#include <cca/modes.hpp>

#include "graphs.hpp"

using namespace record_test;

namespace {

// It also asks, as a robot with a switch for it may.
struct asking_leg {
  auto sense(cca::beat now)
      -> std::tuple<cca::out<"angles", leg_angles>, cca::stops<"swing">, cca::starts<"swing">> {
    return {at, now.index() == 120, now.index() == 150};
  }
  void act(cca::in<"command", leg_angles> to) { at = 0.7 * at + 0.3 * to.vector(); }
  Eigen::Vector2d at{0.1, -0.2};
};
struct swing {
  auto process(cca::in<"x", leg_angles> x, cca::beat now) -> cca::out<"angles", leg_angles> {
    phase += 6 * now.dt();
    return Eigen::Vector2d(0.3 * std::sin(phase), -0.5 + 0.1 * x[hip{}]);
  }
  void on_start() { phase = 0; }
  double phase = 0;
};
struct swinging : cca::graph<cca::node<"shape", swing, cca::timed<2>>,
                             cca::expose<"shape.x", "x">,
                             cca::expose<"shape.angles", "angles">> {};
struct mind {
  auto process(cca::in<"x", leg_angles> x, cca::beat now)
      -> std::tuple<cca::out<"height", steps>, cca::stops<"swing">, cca::starts<"swing">> {
    return {x[hip{}], now.index() % 50 == 20, now.index() % 50 == 33};
  }
};
struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"leg", asking_leg>,
                         cca::node<"mind", mind>,
                         cca::node<"swing", swinging, cca::stoppable<>>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
                         cca::wire<"leg.angles", "mind.x", cca::delayed<1>>,
                         cca::wire<"leg.angles", "swing.x", cca::delayed<1>>,
                         cca::wire<"swing.angles", "limits.command", cca::delayed<1>>,
                         cca::wire<"limits.safe", "leg.command", cca::latest>>,
              cca::recordable {};
struct split : cca::deployment<walk,
                               cca::environment<"robot", cca::nodes<"leg", "limits">>,
                               cca::environment<"mind", cca::other_nodes>>,
               cca::recordable {};
struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"again", walk>>, cca::recordable {};

template <class Controller>
void drive(Controller& c) {
  c.run(cca::for_beats<100>{});
  c.template stop<"swing">();
  c.run(cca::for_beats<12>{});
  c.template start<"swing">();
  c.run(cca::for_beats<150>{});
  c.stop("swing");
  c.stop();
  c.start();
  c.run(cca::for_beats<50>{});
}

template <class Controller, class Whole>
void check_replay(const char* name) {
  const temporary_file file(name);
  {
    Controller c;
    c.load();
    cca::recording::recorder recording(c, file.path, {.waits = true});
    c.start();
    drive(c);
  }
  const auto result = cca::recording::replay<Whole>(file.path);
  CAPTURE(result.difference);
  CAPTURE(result.ended_early);
  CHECK(result);
  CHECK_EQ(result.beats, 312);
}

}  // namespace

TEST_SUITE("recorded parts") {
  TEST_CASE("of one loop") { check_replay<cca::controller<walk>, walk>("parts"); }
  TEST_CASE("of environments") { check_replay<cca::deployed<split>, split>("parts_split"); }
  TEST_CASE("of a set of modes") { check_replay<cca::controller<legs>, legs>("parts_modes"); }

  TEST_CASE("a recording that begins while a part is stopped") {
    const temporary_file file("parts_stopped");
    {
      cca::controller<walk> c;
      c.load();
      c.start();
      c.stop<"swing">();
      cca::recording::recorder recording(c, file.path, {.waits = true});
      drive(c);
    }
    const auto result = cca::recording::replay<walk>(file.path);
    CAPTURE(result.difference);
    CHECK(result);
  }
}
