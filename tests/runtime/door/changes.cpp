// What clients of a door change: parameters and services, and why not.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "opened.hpp"

using namespace door_test;
using about = fake_controls::about;
using how = fake_controls::how;

namespace {

struct commanding : opened {
  explicit commanding(const cca::detail::door_limits& limits = {}) : opened({}, limits), c(port(), token) {
    REQUIRE(c.call("/cca/take_command").empty());
  }
  client c;
  // What the value is after that, and why it was refused.
  std::pair<json, std::string> set(const std::string& name, const json& value) {
    c.texts.clear();
    c.set(name, value, "it");
    const json values = c.next("parameterValues");
    CHECK(values["id"] == "it");
    std::string why;
    for (const auto& one : c.texts)
      if (one["op"] == "status") why = one["message"];
    return {values["parameters"].empty() ? json() : values["parameters"][0]["value"], why};
  }
};

}  // namespace

TEST_CASE("A parameter of each kind is set") {
  commanding one;
  CHECK(one.set("gait.frequency", 2.25) == std::pair<json, std::string>(2.25, ""));
  CHECK(one.set("gait.frequency", 2).first == 2.0);
  CHECK(one.set("gait.steps", 4).first == 4);
  CHECK(one.set("gait.steps", 5.0).first == 5);
  CHECK(one.set("gait.is_on", false).first == false);
  CHECK(one.set("gait.kind", "walk").first == "walk");
  CHECK(one.set("gait.gains", {4, 5, 6.5}).first == json({4.0, 5.0, 6.5}));
}

TEST_CASE("A wrong value is refused with unit and range, and the old one goes back") {
  commanding one;
  const auto is_refused = [&](const std::string& name, const json& value, const json& stays,
                              const std::string& why) {
    const auto [is, told] = one.set(name, value);
    CHECK(is == stays);
    CHECK(told == "setParameters: " + name + " = " + why);
  };
  is_refused("gait.frequency", 9, 1.5, "9: expected a number from 0.1 to 5 Hz");
  is_refused("gait.frequency", 0.09, 1.5, "0.09: expected a number from 0.1 to 5 Hz");
  is_refused("gait.frequency", 5.0000000001, 1.5, "5.0000000001: expected a number from 0.1 to 5 Hz");
  is_refused("gait.frequency", std::nextafter(5, 6), 1.5,
             "5.000000000000001: expected a number from 0.1 to 5 Hz");
  is_refused("gait.frequency", "2", 1.5, "\"2\": expected a number in Hz");
  is_refused("gait.frequency", nullptr, 1.5, "null: expected a value: a parameter can't be removed");
  is_refused("gait.steps", 10, 3, "10: expected a whole number from 1 to 9");
  is_refused("gait.steps", 2.5, 3, "2.5: expected a whole number");
  is_refused("gait.steps", 1e300, 3, "1e+300: expected a whole number");
  is_refused("gait.steps", 18446744073709551615u, 3, "18446744073709551615: expected a whole number");
  is_refused("gait.is_on", 1, true, "1: expected true or false");
  is_refused("gait.kind", "run", "trot", "\"run\": expected one of trot, walk");
  is_refused("gait.kind", 3, "trot", "3: expected one of trot, walk");
  is_refused("gait.gains", {1, 2}, {1.0, 2.0, 3.0}, "[1,2]: expected 3 numbers from 0 to 10");
  is_refused("gait.gains", {1, 2, 11}, {1.0, 2.0, 3.0}, "[1,2,11]: expected 3 numbers from 0 to 10");
  is_refused("gait.gains", {1, 2, "3"}, {1.0, 2.0, 3.0}, "[1,2,\"3\"]: expected 3 numbers from 0 to 10");
  is_refused("gait.gains", 1, {1.0, 2.0, 3.0}, "1: expected 3 numbers from 0 to 10");
  CHECK(one.set("no.such", 1).second == "setParameters: there is no parameter \"no.such\"");
  one.c.text({{"op", "setParameters"}, {"parameters", json::array()}});
  CHECK(one.c.is_told("expected a list `parameters`"));
  one.c.text({{"op", "setParameters"}, {"parameters", {1}}});
  CHECK(one.c.is_told("expected a list `parameters`"));
  one.c.text({{"op", "setParameters"}, {"parameters", json::array({{{"name", "gait.steps"}}})}});
  CHECK(one.c.is_told("a parameter can't be removed"));
  one.c.wire.send(
      frame_of(0x81, R"({"op":"setParameters","parameters":[{"name":"gait.frequency","value":1e999}]})"));
  CHECK(one.c.is_told("expected an object of JSON"));
  CHECK(one.controls.asked().empty());
}

TEST_CASE("Of one request all is set, or nothing") {
  commanding one;
  one.c.text({{"op", "setParameters"},
              {"id", "x"},
              {"parameters", json::array({{{"name", "gait.frequency"}, {"value", 3}},
                                          {{"name", "gait.steps"}, {"value", 99}}})}});
  CHECK(one.c.is_told("gait.steps = 99"));
  CHECK(one.c.next("parameterValues")["parameters"][0]["value"] == 1.5);
  one.c.text({{"op", "setParameters"},
              {"id", "y"},
              {"parameters", json::array({{{"name", "gait.frequency"}, {"value", 3}},
                                          {{"name", "gait.steps"}, {"value", 9}}})}});
  CHECK(one.c.next("parameterValues")["parameters"].size() == 2);
  REQUIRE(one.controls.asked().size() == 1);
  CHECK(one.controls.asked()[0].values.size() == 2);
}

TEST_CASE("What is set twice in one request is refused, with all the rest of it") {
  commanding one;
  one.c.text({{"op", "setParameters"},
              {"id", "x"},
              {"parameters", json::array({{{"name", "gait.frequency"}, {"value", 2}},
                                          {{"name", "gait.steps"}, {"value", 4}},
                                          {{"name", "gait.frequency"}, {"value", 3}}})}});
  CHECK(one.c.is_told("setParameters: \"gait.frequency\" is set twice"));
  CHECK(one.controls.asked().empty());
}

TEST_CASE("What the controller refuses is told with its reason") {
  commanding one;
  one.controls.answers(how::refused);
  CHECK(one.set("gait.frequency", 2) == std::pair<json, std::string>(1.5, "setParameters: the fake refuses"));
  CHECK(one.c.call("/cca/switch_mode", {{"mode", "walk"}}) == "the fake refuses");
}

TEST_CASE("Every service asks for what its name says") {
  commanding one;
  const auto asks = [&](const std::string& name, const json& arguments, about what) {
    CHECK(one.c.call(name, arguments) == "");
    const auto all = one.controls.asked();
    REQUIRE(!all.empty());
    CHECK(all.back().about == what);
    return all.back();
  };
  asks("/cca/pause", json::object(), about::pause);
  asks("/cca/go_on", json::object(), about::go_on);
  CHECK(asks("/cca/step", {{"beats", 12}}, about::step).number == 12);
  CHECK(asks("/cca/step", json::object(), about::step).number == 1);
  CHECK(asks("/cca/speed", {{"factor", 0.5}}, about::speed).number == 0.5);
  CHECK(asks("/cca/speed", {{"factor", 0.001}}, about::speed).number == 0.001);
  asks("/cca/resume", json::object(), about::resume);
  asks("/cca/start", json::object(), about::start);
  CHECK(asks("/cca/stop_part", {{"part", "arm"}}, about::stop_part).text == "arm");
  CHECK(asks("/cca/start_part", {{"part", "arm"}}, about::start_part).text == "arm");
  CHECK(asks("/cca/switch_mode", {{"mode", "walk"}}, about::switch_mode).text == "walk");
  const auto load = asks("/cca/load", {{"file", "a/b.toml"}, {"scope", "gait"}}, about::load);
  CHECK(load.text == "a/b.toml");
  CHECK(load.scope == "gait");
  CHECK(asks("/cca/save", {{"file", "c.toml"}}, about::save).text == "c.toml");
  CHECK(asks("/cca/record", {{"file", "r.mcap"}}, about::record).text == "r.mcap");
  asks("/cca/end_recording", json::object(), about::end_recording);
  const auto push = asks("/cca/command/push", {{"force", -7.5}}, about::call);
  CHECK(push.text == "push");
  REQUIRE(push.values.size() == 2);
  CHECK(push.values[0].first == "force");
  CHECK(push.values[0].second.number == -7.5);
  CHECK(push.values[1].second.number == 0);  // as it is at first
  CHECK(asks("/cca/release/push", json::object(), about::release).text == "push");
  CHECK(asks("/cca/command/wave", json::object(), about::call).text == "wave");
  asks("/cca/stop", json::object(), about::end_run);
}

TEST_CASE("A wrong call is refused, with the range and the unit") {
  commanding one;
  client& c = one.c;
  CHECK(c.call("/cca/step", {{"beats", 0}}) == "/cca/step: beats = 0: expected a number from 1 to 1000000");
  CHECK(c.call("/cca/step", {{"beats", 1.5}}) ==
        "/cca/step: beats = 1.5: expected a whole number from 1 to 1000000");
  CHECK(c.call("/cca/speed", {{"factor", 0}}) ==
        "/cca/speed: factor = 0: expected a number from 0.001 to 1000");
  CHECK(c.call("/cca/speed", {{"factor", "1"}}) ==
        "/cca/speed: factor = \"1\": expected a number from 0.001 to 1000");
  CHECK(c.call("/cca/command/push", {{"force", 50.1}}) ==
        "/cca/command/push: force = 50.1: expected a number from -50 to 50 N");
  CHECK(c.call("/cca/command/push", {{"power", 1}}) ==
        "/cca/command/push: it has no argument \"power\", only force angle");
  CHECK(c.call("/cca/pause", {{"x", 1}}) == "/cca/pause: it has no argument \"x\", and no other");
  CHECK(c.call("/cca/switch_mode") == "/cca/switch_mode: say which mode");
  CHECK(c.call("/cca/stop_part", {{"part", ""}}) == "/cca/stop_part: say which part");
  CHECK(c.call("/cca/load", {{"file", 3}}) == "/cca/load: file = 3: expected a text");
  for (const char* file : {"/etc/x.toml", "../x.toml", "a/../../x.toml", "x.txt", "x\n.toml", "..", "x.mcap"})
    CHECK(c.call("/cca/save", {{"file", file}})
              .find("expected a file below the folder in which the program runs") != std::string::npos);
  for (const char* file : {"x.toml", ".mcap", " .mcap", "a/.mcap", " a.mcap", "a/ b.mcap", "a/"})
    CHECK(c.call("/cca/record", {{"file", file}}).find("with the ending .mcap") != std::string::npos);
  CHECK(c.call("/cca/save", {{"file", ".toml"}}).find("with the ending .toml") != std::string::npos);
  for (const char* service : {"/cca/load", "/cca/save", "/cca/record"})
    CHECK(c.call(service).find("say which file: expected a file below the folder") != std::string::npos);
  CHECK(c.call("/cca/undo") == "/cca/undo: nothing was changed");
  const auto fails = [&](std::uint32_t service, std::string_view payload, std::string_view encoding,
                         const std::string& why) {
    c.wire.send(frame_of(0x82, client::bytes_of_call(service, 9, payload, encoding)));
    CHECK(c.next("serviceCallFailure")["message"] == why);
  };
  fails(0, "{}", "json", "there is no service 0");
  fails(4000000000u, "{}", "json", "there is no service 4000000000");
  fails(3, "{}", "cdr", "the services of this door speak json");
  fails(3, "{", "json", "expected an object of JSON, at most 16 deep");
  fails(3, "[]", "json", "expected an object of JSON, at most 16 deep");
  CHECK(one.controls.asked().empty());
}

TEST_CASE("The last changes are undone, one after the other, a loaded file too") {
  commanding one;
  one.set("gait.frequency", 2);
  one.c.text({{"op", "setParameters"},
              {"id", "y"},
              {"parameters", json::array({{{"name", "gait.frequency"}, {"value", 3}},
                                          {{"name", "gait.steps"}, {"value", 9}}})}});
  one.c.next("parameterValues");
  one.set("gait.frequency", 77);                                 // refused: nothing to undo
  one.set("gait.frequency", 3);                                  // as it is: nothing to undo
  CHECK(one.c.call("/cca/load", {{"file", "x.toml"}}).empty());  // 0.7 Hz
  const auto value = [&](std::size_t i) { return one.controls.parameters()->at(i).value; };
  CHECK(value(0).number == 0.7);
  CHECK(one.c.call("/cca/undo").empty());
  CHECK(value(0).number == 3);
  CHECK(one.c.call("/cca/undo").empty());
  CHECK(value(0).number == 2);
  CHECK(value(1).integer == 3);
  CHECK(one.c.call("/cca/undo").empty());
  CHECK(value(0).number == 1.5);
  CHECK(one.c.call("/cca/undo") == "/cca/undo: nothing was changed");
}

TEST_CASE("A request that no beat takes is refused, and it is told when it has effect after all") {
  commanding one({.taken_time = 300ms});
  one.controls.answers(how::begun);
  const auto first = one.c.send_call("/cca/switch_mode", {{"mode", "walk"}}),
             second = one.c.send_call("/cca/pause");
  CHECK(one.c.answer_of(first) == "the loop has not begun a beat since; the next one takes it");
  CHECK(one.c.answer_of(second) == "the loop has not begun a beat since");
  one.controls.answers(how::done);
  CHECK(soon([&] { return one.controls.was_asked(about::switch_mode); }));
  CHECK(one.c.call("/cca/go_on").empty());
  CHECK_FALSE(one.controls.was_asked(about::pause));  // it was refused, so it never happens
  CHECK(soon([&] {
    return one.controls.noted().size() == 3 &&
           one.controls.noted()[1].ends_with("/cca/switch_mode walk (late)");
  }));
}

TEST_CASE("A controller that is busy for a while takes the requests in their order") {
  commanding one;
  one.controls.answers(how::busy);
  const auto first = one.c.send_call("/cca/pause"), second = one.c.send_call("/cca/go_on");
  one.c.set("gait.steps", 8, "z");
  one.c.read(100ms);
  CHECK(one.c.answers.size() == 1);  // of take_command
  one.controls.answers(how::done);
  CHECK(one.c.answer_of(first).empty());
  CHECK(one.c.answer_of(second).empty());
  CHECK(one.c.next("parameterValues")["parameters"][0]["value"] == 8);
  const auto all = one.controls.asked();
  REQUIRE(all.size() == 3);
  CHECK(all[0].about == about::pause);
  CHECK(all[1].about == about::go_on);
  CHECK(all[2].about == about::set);
}

TEST_CASE("No more requests wait than a number, but the emergency stop is not one of them") {
  commanding one({.requests = 4});
  one.controls.answers(how::begun);
  std::vector<std::uint32_t> calls;
  for (int i = 0; i < 6; ++i) calls.push_back(one.c.send_call("/cca/pause"));
  CHECK(one.c.answer_of(calls[5]) ==
        "too many requests wait for the controller: try again");  // one has begun, four wait
  one.c.set("gait.steps", 8);
  CHECK(one.c.is_told("too many requests wait for the controller"));
  client other(one.port(), token);
  CHECK(other.call("/cca/stop").empty());
  CHECK(one.controls.was_asked(about::end_run));
  CHECK(one.c.answer_of(calls[0]) == "the run was stopped");
}
