// cca-call test as a person who tunes runs it, on the axis of docs/tuning.md.
#include <doctest/doctest.h>

#include <signal.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "../door/tuned_axis.hpp"
#include "ran.hpp"

namespace {

using namespace door_tools_test;
using door_test::client;
using door_test::json;

// One that runs: then a test is refused for what it is.
struct tuned_program : door_test::tuned_axis {
  tuned_program() : seen(door.port(), door.token()) {
    const json wrong{{"input", "servo.reference"}, {"output", "drive.angle"}, {"signal", "step"}};
    seen.call("/cca/take_command");
    REQUIRE(seen.waits([&] { return seen.call("/cca/test", wrong).find("not begun") == std::string::npos; }));
    seen.call("/cca/give_command");
  }
  words all(words arguments) const {
    arguments.insert(arguments.begin(), {std::to_string(door.port()), "test"});
    return arguments;
  }
  words environment() const { return {"CCA_TOKEN=" + std::string(door.token())}; }
  ran test(const words& arguments) const { return running(CCA_CALL, all(arguments), environment()).end(); }
  bool signal_becomes(const std::string& wanted) {
    return seen.waits([&] {
      seen.text({{"op", "getParameters"}, {"parameterNames", {"test_servo_reference.signal"}}, {"id", "s"}});
      return seen.next("parameterValues")["parameters"][0]["value"] == wanted;
    });
  }
  client seen;
};

}  // namespace

TEST_CASE("cca-call test prints the figures of a step, and the response by a chirp, as lines or JSON") {
  tuned_program p;
  const ran step = p.test({"servo.reference", "drive.angle", "step", "amplitude=0.1", "duration=2"});
  CHECK_EQ(step.err, "");
  CHECK_EQ(step.code, 0);
  std::istringstream figures(step.out);
  const auto figure = [&](const std::string& name, const std::string& unit) {
    std::string line, is;
    std::getline(figures, line);
    std::istringstream one(line);
    double value = std::nan("");
    one >> is >> value;
    CHECK_EQ(is, name);
    CHECK(line.ends_with(unit));
    return value;
  };
  CHECK(figure("gain", "") == doctest::Approx(1).epsilon(0.05));
  CHECK(figure("rise_time", " s") == doctest::Approx(0.138).epsilon(0.05));  // as docs/tuning.md
  CHECK(figure("overshoot", "") == doctest::Approx(0.31).epsilon(0.05));
  CHECK(figure("settling_time", " s") == doctest::Approx(1.095).epsilon(0.1));

  const ran chirp = p.test({"servo.reference", "drive.angle", "chirp", "amplitude=0.05", "frequency=0.5",
                            "to=50", "duration=10", "from=limits.safe"});
  CHECK_EQ(chirp.err, "");
  CHECK_EQ(chirp.code, 0);
  std::istringstream lines(chirp.out);
  std::string head;
  std::getline(lines, head);
  CHECK_EQ(head, "# frequency Hz, gain, phase deg, coherence");
  int count = 0;
  for (double f, gain, phase, coherence; lines >> f >> gain >> phase >> coherence; ++count) {
    if (f < 2 || f > 20) continue;
    const double w = 2 * cca::pi * f;
    CHECK(gain == doctest::Approx(1 / (w * std::hypot(0.01 * w, 0.02))).epsilon(0.02));
    const double wanted = (-cca::pi / 2 - std::atan2(0.01 * w, 0.02) - 0.5e-3 * w) * 180 / cca::pi;
    CHECK(std::abs(std::remainder(phase - wanted, 360)) < 2);
    CHECK(coherence > 0.98);
  }
  CHECK_EQ(count, 60);

  const ran sine = p.test({"servo.reference", "drive.angle", "sine", "amplitude=0.05", "frequency=3",
                           "duration=2", "axis=arm", "output_axis=arm", "--json"});
  const json one = json::parse(sine.out);
  CHECK_EQ(one["signal"], "sine");
  CHECK_EQ(one["frequency"], json::array({3.0}));
  CHECK(one["coherence"][0] > 0.98);

  const ran described = running(CCA_CALL, {std::to_string(p.door.port()), "describe"}, p.environment()).end();
  CHECK_NE(described.out.find("\ntest servo.reference (up to 0.2 rad)\n"), std::string::npos);
}

TEST_CASE("cca-call test says why a test is refused, and leaves nothing behind") {
  tuned_program p;
  const auto refused = [&](const words& arguments, const std::string& why) {
    const ran one = p.test(arguments);
    CHECK_EQ(one.code, 2);
    CHECK_EQ(one.out, "");
    CHECK_MESSAGE(one.err.find(why) != std::string::npos, one.err);
    CHECK_EQ(std::count(one.err.begin(), one.err.end(), '\n'), 1);
  };
  const std::string in = "servo.reference", to = "drive.angle";
  refused({in, to, "step", "amplitude=0.21"}, "expected a number from -0.2 to 0.2 rad");
  refused({in, to, "step"}, "amplitude: expected one that is not 0, at most 0.2 rad");
  refused({in, to, "step", "amplitude=much"}, "cca-call: amplitude");
  refused({in, to, "step", "amplitude"}, "expected NAME=VALUE, as amplitude=0.1");
  refused({in, to, "step", "amplitude=nan"}, "cca-call: amplitude");
  refused({in, to, "square"}, "signal = \"square\": expected step, sine, chirp or linear_chirp");
  refused({in, to, "step", "amplitud=0.1"}, "it has no argument \"amplitud\", only axis amplitude");
  refused({in, to, "step", "amplitude=0.1", "axis=elbow"}, "axis = \"elbow\": expected an axis: arm, or");
  refused({in, to, "step", "amplitude=0.1", "output_axis=elbow"},
          "output_axis = \"elbow\": expected an axis of drive.angle: arm, or");
  refused({in, to, "step", "amplitude=0.1", "output_axis=1"},
          "output_axis = 1: expected an axis of drive.angle: arm, or its number, a whole number from 0 to 0");
  refused({in, to, "step", "amplitude=0.1", "axis=1"},
          "axis = 1: expected an axis: arm, or its number, a whole number from 0 to 0");
  refused({in, "drive", "step", "amplitude=0.1"},
          "output = \"drive\": expected the path of an output, did you mean "
          "`drive.angle`?");
  refused({"servo.measured", to, "step", "amplitude=0.1"},
          "that a cca::test_input declares: servo.reference");
  refused({in, "drive.speed", "step", "amplitude=0.1"}, "expected the path of an output");
  refused({in, to, "chirp", "amplitude=0.1", "to=500"}, "below half its rate");
  refused({in, to}, "expected `test INPUT OUTPUT SIGNAL");
  const ran no_token = running(CCA_CALL, p.all({in, to, "step", "amplitude=0.1"})).end();
  CHECK_EQ(no_token.code, 2);
  CHECK_EQ(no_token.err, "cca-call: a change needs the token: --token, --token-file or CCA_TOKEN\n");
  REQUIRE_EQ(p.seen.call("/cca/take_command"), "");
  refused({in, to, "step", "amplitude=0.1"}, "commands: it must give the command back first");
}

TEST_CASE("cca-call test ends its test at ctrl-c, and when it is killed") {
  tuned_program p;
  const words longest{"servo.reference", "drive.angle", "chirp", "amplitude=0.05", "duration=600"};
  for (const int signal : {SIGINT, SIGKILL}) {
    running one(CCA_CALL, p.all(longest), p.environment());
    REQUIRE(p.signal_becomes("chirp"));
    one.send(signal);
    CHECK_EQ(one.end().code, 128 + signal);
    CHECK(p.signal_becomes("off"));
  }
  p.end();
  CHECK_FALSE(p.c.get<"test_servo_reference">().is_running());
}
