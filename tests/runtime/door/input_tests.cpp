// A test of an input through a door: begun, answered, refused, and ended with the right to command.
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <iterator>
#include <cstring>
#include <string>
#include <thread>

#include <cca/door.hpp>
#include <cca/door/network/input_tests_functions.hpp>
#include <cca/record.hpp>

#include "../../laws/temporary_file.hpp"
#include "client.hpp"
#include "tuned_axis.hpp"

using door_test::client;
using door_test::json;
using door_test::tuned_axis;
using controller = tuned_axis::controller;

namespace {

json chirp(double seconds = 5) {
  return {{"input", "servo.reference"}, {"output", "drive.angle"}, {"signal", "chirp"},
          {"amplitude", 0.05},          {"frequency", 0.5},        {"to", 50},
          {"duration", seconds}};
}
json with(json of, const char* name, const json& value) {
  of[name] = value;
  return of;
}
// The answer when the test is over; null: it did not come.
json response(client& c) {
  json found;
  c.waits(
      [&] {
        const auto call = c.send_call("/cca/response");
        c.answer_of(call);
        for (const auto& [of, answer] : c.answers)
          if (of == call && answer["success"] == true) found = answer["response"];
        if (found.is_null()) std::this_thread::sleep_for(std::chrono::milliseconds(30));
        return !found.is_null();
      },
      std::chrono::milliseconds(20000));
  return found;
}

}  // namespace

TEST_CASE("input tests: a chirp gives the plant of the axis, and gains that make its step fast") {
  tuned_axis r;
  client c(r.door.port(), r.door.token());
  CHECK(c.call("/cca/test", chirp()).find("take_command") != std::string::npos);
  REQUIRE(c.call("/cca/take_command") == "");
  std::string said;
  c.waits([&] { return (said = c.call("/cca/test", with(chirp(20), "from", "limits.safe"))).empty(); });
  REQUIRE(said == "");
  CHECK(c.call("/cca/test", chirp()).find("a test of servo.reference runs") != std::string::npos);
  CHECK(c.call("/cca/response").find("runs") != std::string::npos);
  const json plant = response(c);
  REQUIRE(plant["frequency"].size() == 60);
  // The motor: 1 / (0.01 s^2 + 0.02 s), its torque held for a beat.
  for (std::size_t i = 0; i < 60; ++i) {
    const double w = 2 * cca::pi * plant["frequency"][i].get<double>();
    if (w < 2 * cca::pi * 1 || w > 2 * cca::pi * 30) continue;
    const double gain = 1 / (w * std::hypot(0.01 * w, 0.02));
    const double phase = -cca::pi / 2 - std::atan2(0.01 * w, 0.02) - 0.5e-3 * w;
    CHECK(plant["gain"][i].get<double>() == doctest::Approx(gain).epsilon(0.01));
    const double turns = (plant["phase"][i].get<double>() - phase) / (2 * cca::pi);
    CHECK(std::abs(turns - std::round(turns)) * 360 < 1);
    CHECK(plant["coherence"][i].get<double>() > 0.98);
  }

  const json step = with(with(chirp(1.5), "signal", "step"), "amplitude", 0.1);
  const auto comes_to_rest = [] { std::this_thread::sleep_for(std::chrono::milliseconds(400)); };
  comes_to_rest();
  REQUIRE(c.call("/cca/test", step) == "");
  const json before = response(c);
  c.set("servo.proportional", json::array({20.0}), "gains");
  CHECK(c.next("parameterValues")["parameters"].size() == 1);
  c.set("servo.derivative", json::array({0.8}), "gains");
  c.next("parameterValues");
  comes_to_rest();
  REQUIRE(c.call("/cca/test", step) == "");
  const json after = response(c);
  CHECK(before["overshoot"].get<double>() > 0.2);
  CHECK(after["overshoot"].get<double>() < 0.25);
  CHECK(after["rise_time"].get<double>() < 0.5 * before["rise_time"].get<double>());
  CHECK(after["gain"].get<double>() == doctest::Approx(1).epsilon(0.01));
  CHECK(after["output"].size() == after["time"].size());

  // What was tuned is saved with what it was, and nothing of the test.
  const std::string file = "cca_test_saved_by_door.toml";
  REQUIRE(c.call("/cca/save", {{"file", file}}) == "");
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  CHECK(text.find("proportional = [20.0]  # was [1.0]\n") != std::string::npos);
  CHECK(text.find("test_servo") == std::string::npos);
  std::remove(file.c_str());

  // An undo takes back the gains, one after the other, and no test.
  CHECK(c.call("/cca/undo") == "");
  CHECK(c.call("/cca/undo") == "");
  CHECK(c.call("/cca/undo").find("nothing was changed") != std::string::npos);
  c.text({{"op", "getParameters"},
          {"parameterNames", {"servo.proportional", "test_servo_reference.run"}},
          {"id", "now"}});
  const json now = c.next("parameterValues")["parameters"];
  CHECK(now[0]["value"] == json::array({1.0}));
  CHECK(now[1]["value"] == 3);
}

// As nearly every script does: it comes, reads one, and goes.
TEST_CASE("who reads the status after a while is told of now, not of the last reader") {
  tuned_axis r;
  const auto beat = [&] {
    client c(r.door.port());
    c.subscribe(5, 60001);
    REQUIRE(c.waits([&] { return !c.samples.empty(); }));
    return json::parse(c.samples[0].data)["beat"].get<std::int64_t>();
  };
  CHECK(beat() > 0);  // not as it was before the run
  const std::int64_t before = beat();
  std::this_thread::sleep_for(std::chrono::milliseconds(500));  // 5000 beats
  CHECK(beat() > before + 500);
}

TEST_CASE("input tests: a sine through a door") {
  tuned_axis r;
  client c(r.door.port(), r.door.token());
  REQUIRE(c.call("/cca/take_command") == "");
  json sine = with(with(chirp(4), "signal", "sine"), "frequency", 3);
  sine["axis"] = sine["output_axis"] = "arm";  // a name is as good as a number
  std::string said;
  c.waits([&] { return (said = c.call("/cca/test", sine)).empty(); });
  REQUIRE(said == "");
  const json one = response(c);
  REQUIRE(one["gain"].size() == 1);
  // PD with the derivative on the measurement: P / (P + s D + kp) of the motor.
  const std::complex<double> s(0, 2 * cca::pi * 3), plant = 1.0 / (s * (0.01 * s + 0.02));
  const auto loop = plant / (1.0 + plant * (1.0 + 0.05 * s));
  CHECK(one["gain"][0].get<double>() == doctest::Approx(std::abs(loop)).epsilon(0.02));
}

TEST_CASE("input tests: what is no test is refused, and says why") {
  tuned_axis r;
  client c(r.door.port(), r.door.token()), other(r.door.port());
  REQUIRE(c.call("/cca/take_command") == "");
  CHECK(c.waits([&] {
    return c.call("/cca/test", with(chirp(), "amplitude", 9)) != "/cca/test: the run has not begun";
  }));
  const auto refused = [&](const char* name, const json& value, const char* why) {
    const std::string said = c.call("/cca/test", with(chirp(), name, value));
    CAPTURE(said);
    CHECK(said.find(why) != std::string::npos);
  };
  refused("amplitude", 0.21, "expected a number from -0.2 to 0.2 rad");
  refused("amplitude", 0, "not 0");
  refused("amplitude", nullptr, "expected a number");
  refused("amplitude", "x", "expected a number");
  refused("frequency", 500, "below half its rate");
  refused("to", 500, "below half its rate");
  refused("frequency", 0, "from 0.001");
  refused("duration", 0, "expected a number from");
  refused("duration", 1e9, "expected a number from");
  refused("axis", 1, "axis = 1: expected an axis: arm, or its number, a whole number from 0 to 0");
  refused("axis", 0.5, "axis = 0.5: expected an axis");
  refused("axis", "elbow", "axis = \"elbow\": expected an axis: arm");
  refused("output_axis", -1, "output_axis = -1: expected an axis of drive.angle: arm, or its number");
  refused("output_axis", 1,
          "output_axis = 1: expected an axis of drive.angle: arm, or its number, a whole number from 0 to 0");
  refused("output_axis", 99, "output_axis = 99: expected an axis");
  refused("output_axis", "elbow", "output_axis = \"elbow\": expected an axis of drive.angle: arm");
  refused("output_axis", nullptr, "output_axis = null: expected an axis");
  refused("signal", "square", "signal = \"square\": expected step, sine, chirp or linear_chirp");
  refused("signal", "off", "expected step");
  refused("signal", nullptr, "expected step");
  refused("amplitud", 0.1, "it has no argument \"amplitud\", only axis amplitude");
  refused("output", "drive", "expected the path of an output, did you mean `drive.angle`?");
  refused("output", "zzz", "expected the path of an output, as `cca.describe` lists them");
  refused("input", "servo.measured", "that a cca::test_input declares: servo.reference");
  refused("output", "drive.speed", "expected the path of an output");
  refused("from", "limits.unsafe", "expected the path of an output");
  refused("output", "cca.state", "expected the path of an output");  // it has no axes
  const std::string from = c.call("/cca/test", with(with(chirp(), "from", "limits.safe"), "from_axis", 2));
  CHECK(from.find("from_axis = 2: expected an axis of limits.safe: arm") != std::string::npos);
  c.wire.send(door_test::frame_of(0x82, client::bytes_of_call(0, 1, "{}")));
  CHECK(c.call("/cca/end_test").find("no test runs") != std::string::npos);
  CHECK(other.call("/cca/test", chirp()).find("token") != std::string::npos);
  CHECK(other.call("/cca/response").find("token") != std::string::npos);
  client third(r.door.port(), r.door.token());
  CHECK(third.call("/cca/test", chirp()).find("has it and must give it back") != std::string::npos);
  CHECK(third.call("/cca/end_test").find("has it and must give it back") != std::string::npos);
  CHECK(third.call("/cca/response").find("no test has run") != std::string::npos);
}

TEST_CASE("input tests: what an earlier one or a client has set does not spoil the next") {
  tuned_axis r;
  client c(r.door.port(), r.door.token());
  REQUIRE(c.call("/cca/take_command") == "");
  // A step has no frequency, so none is refused, and none is kept.
  const json step = with(with(with(chirp(0.5), "signal", "step"), "to", 600), "frequency", 700);
  std::string said;
  c.waits([&] { return (said = c.call("/cca/test", step)).empty(); });
  REQUIRE(said == "");
  CHECK(!response(c).is_null());
  CHECK(c.call("/cca/test", chirp(0.5)) == "");
  CHECK(!response(c).is_null());
  CHECK(c.call("/cca/test", step) == "");
  CHECK(!response(c).is_null());
  c.set("test_servo_reference.signal", "off", "off");
  c.next("parameterValues");
  c.set("test_servo_reference.frequency", 800, "high");
  CHECK(c.next("parameterValues")["parameters"][0]["value"] == 800);
  CHECK(c.call("/cca/test", chirp(0.5)) == "");
}

TEST_CASE("input tests: one that is refused for its values leaves the answer of the one before") {
  tuned_axis r;
  client c(r.door.port(), r.door.token());
  REQUIRE(c.call("/cca/take_command") == "");
  const json far = with(chirp(0.5), "amplitude", 5);
  std::string said;
  c.waits([&] { return (said = c.call("/cca/test", far)).find("amplitude") != std::string::npos; });
  REQUIRE(said.find("amplitude") != std::string::npos);
  CHECK(c.call("/cca/response").find("no test has run") != std::string::npos);
  REQUIRE(c.call("/cca/test", chirp(0.5)) == "");
  const json answer = response(c);
  REQUIRE(!answer.is_null());
  CHECK(c.call("/cca/test", far).find("amplitude") != std::string::npos);
  CHECK(response(c) == answer);
}

TEST_CASE("input tests: one ends with its end, the right to command, its connection, and the run") {
  tuned_axis r;
  const auto is_off = [&](client& from) {
    return from.waits([&] {
      from.text({{"op", "getParameters"}, {"parameterNames", {"test_servo_reference.signal"}}, {"id", "s"}});
      const json values = from.next("parameterValues");
      return values["parameters"][0]["value"] == "off";
    });
  };
  client seen(r.door.port());
  {
    client c(r.door.port(), r.door.token());
    REQUIRE(c.call("/cca/take_command") == "");
    std::string said;
    c.waits([&] { return (said = c.call("/cca/test", chirp(100))).empty(); });
    REQUIRE(said == "");
    std::this_thread::sleep_for(std::chrono::milliseconds(300));  // some seconds of the run
    CHECK(c.call("/cca/end_test") == "");
    CHECK(is_off(seen));
    CHECK(!response(c).is_null());
    REQUIRE(c.call("/cca/test", chirp(100)) == "");
    CHECK(c.call("/cca/give_command") == "");
    CHECK(is_off(seen));
    REQUIRE(c.call("/cca/take_command") == "");
    REQUIRE(c.call("/cca/test", chirp(100)) == "");
  }  // its connection is lost
  CHECK(is_off(seen));
  client c(r.door.port(), r.door.token());
  REQUIRE(c.call("/cca/take_command") == "");
  REQUIRE(c.call("/cca/test", chirp(100)) == "");
  r.end();
  CHECK_FALSE(r.c.get<"test_servo_reference">().is_running());
}

TEST_CASE("input tests: a recording of one, also of one that was ended, replays bit for bit") {
  const laws::temporary_file file("input_test");
  {
    controller c;
    cca::recording::recorder recording(c, file.path, {.waits = true});
    c.load();
    c.start();
    c.run(cca::for_beats<500>{});
    auto p = c.get<"test_servo_reference">().p;
    p.signal = cca::test_signal::chirp, p.amplitude = 0.1, p.frequency = 1, p.to = 80, p.duration = 1,
    p.run = 1;
    c.set<"test_servo_reference">(p);
    c.run(cca::for_beats<1500>{});
    p.signal = cca::test_signal::sine, p.duration = 600, p.run = 2;
    c.set<"test_servo_reference">(p);
    c.run(cca::for_beats<300>{});
    c.set("test_servo_reference.signal", "off");
    c.run(cca::for_beats<300>{});
    recording.close();
    CHECK(recording.problem() == "");
  }
  const auto result = cca::recording::replay<tuning::axis>(file.path);
  INFO(result);
  CHECK(result);
  CHECK(result.beats == 2600);
}

TEST_CASE("input tests: without a whole record there is no answer, and the reason is told") {
  namespace network = cca::detail::door_network;
  network::wanted_channels wanted;
  network::shown_channels channels(wanted);
  channels.add(
      {.id = 1, .topic = "/drive/angle", .type = "cca.angle", .schema = "{}", .metadata = {{"axes", "arm"}}});
  const std::vector<cca::detail::door_test_input> inputs{
      {.input = "servo.reference", .node = "test_servo_reference", .axes = {"axis"}, .most = 0.2}};
  network::input_test test;
  const json asked = with(chirp(1), "to", 10);
  CHECK(test.read(asked, inputs, channels) == "the run has not begun");
  channels.add(
      {.id = 2, .topic = "/test_servo_reference/excitation", .type = "cca.excitation", .schema = "{}"});
  REQUIRE(test.read(asked, inputs, channels) == "");
  cca::detail::door_request request;
  CHECK(test.fill({}, request) == "the run has not begun");

  constexpr std::uint64_t over = 5'000'000'000;
  const auto why = [&] {
    std::string said;
    CHECK_FALSE(test.response(over, said).has_value());
    return said;
  };
  CHECK(why() == "no test has run: call /cca/test");
  const auto begin = [&] {
    test.begin(1, 1'000'000, channels);
    test.begun(0);
  };
  begin();
  CHECK(why() == "the test has too few samples: was the run paused, or stopped?");
  test.end(channels);
  begin();
  test.lost(3);
  CHECK(why() == "3 samples of the test were lost: run slower, or record it to a file");
  test.end(channels);
  begin();
  for (std::int64_t beat = 0; beat < 300; ++beat)
    for (const std::uint16_t channel : {std::uint16_t{1}, std::uint16_t{2}}) {
      std::string sample(4 + 16 + sizeof(double), '\0');
      std::memcpy(sample.data() + 4, &beat, sizeof beat);
      test.sample(channel, sample);
    }
  CHECK(why().find("the signal ended 0.7 s before its time: was the run stopped, or begun anew?") == 0);
}
