// Who may change anything, and who commands.
#include <doctest/doctest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

#include <cca/base/refused.hpp>

#include "opened.hpp"

using namespace door_test;
using about = fake_controls::about;
using how = fake_controls::how;

namespace {

json rights(bool may_change, bool commands) { return {{"mayChange", may_change}, {"commands", commands}}; }
// The next rights that are told, without who commands.
json next_rights(client& c) {
  json all = c.next("cca.rights");
  if (all.is_null()) return all;
  all.erase("op");
  all.erase("commandedBy");
  return all;
}
// Of a client that has not shown that it knows them.
json asked_rights(client& c) {
  c.text({{"op", "cca.describe"}});
  return next_rights(c);
}
const std::string push = "/cca/command/push";

// A door before a program with an input that may be tested.
struct testable {
  fake_controls controls{};
  cca::detail::door_server door{quiet(), with_test(controls)};

  testable() {
    std::uint16_t id = 0;
    for (const char* topic : {"/robot/angles", "/test_servo_reference/excitation"})
      door.sink().channel({.id = ++id,
                           .topic = topic,
                           .type = "a",
                           .schema = "",
                           .metadata = {{"axes", "arm"}},
                           .is_kept = true});
  }
  std::uint16_t port() const { return door.port(); }
  std::string signal() {
    const auto all = controls.parameters();
    for (const auto& one : all.value_or(std::vector<cca::detail::door_parameter>{}))
      if (one.path == "test_servo_reference.signal") return one.value.text;
    return {};
  }

private:
  static fake_controls& with_test(fake_controls& of) {
    of.offer_test();
    return of;
  }
};
// What this client commands ends when it gives the command back.
void ends_with_right(testable& one, client& c) {
  CHECK(one.signal() == "sine");
  CHECK(c.call("/cca/give_command").empty());
  CHECK(soon([&] { return one.signal() == "off"; }));
}
json sine(double amplitude) {
  return {{"input", "servo.reference"}, {"output", "robot.angles"}, {"signal", "sine"},
          {"amplitude", amplitude},     {"frequency", 1},           {"duration", 600}};
}

std::string why_no_token(cca::door_settings with) {
  fake_controls controls;
  with.port = 0;
  with.tells_where = false;
  try {
    const cca::detail::door_server door(with, controls);
  } catch (const cca::refused& e) { return e.what(); }
  return {};
}

}  // namespace

TEST_CASE("Reading is free, and nothing changes without the token") {
  opened one;
  client c(one.port());
  CHECK(asked_rights(c) == rights(false, false));
  CHECK(c.call("/cca/take_command").find("this needs the token") == 0);
  CHECK(c.call("/cca/give_command").find("this needs the token") == 0);
  for (const auto& service :
       {"/cca/pause", "/cca/go_on", "/cca/step", "/cca/speed", "/cca/stop", "/cca/resume", "/cca/start",
        "/cca/stop_part", "/cca/start_part", "/cca/switch_mode", "/cca/load", "/cca/save", "/cca/record",
        "/cca/end_recording", "/cca/undo", "/cca/command/push", "/cca/release/push", "/cca/command/wave"})
    CHECK(c.call(service).find("this needs the token") == 0);
  c.set("gait.frequency", 2);
  CHECK(c.is_told("setParameters: this needs the token"));
  CHECK(c.next("parameterValues")["parameters"][0]["value"] == 1.5);
  CHECK(one.controls.asked().empty());
  CHECK(one.controls.noted().empty());
}

TEST_CASE("With the token alone only the emergency stop is done") {
  opened one;
  client c(one.port(), token);
  CHECK(next_rights(c) == rights(true, false));
  for (const auto& service :
       {"/cca/pause", "/cca/go_on", "/cca/step", "/cca/speed", "/cca/resume", "/cca/start", "/cca/stop_part",
        "/cca/start_part", "/cca/switch_mode", "/cca/load", "/cca/save", "/cca/record", "/cca/end_recording",
        "/cca/undo", "/cca/command/push", "/cca/release/push", "/cca/command/wave"})
    CHECK(c.call(service) == "this needs the right to command: call /cca/take_command");
  c.set("gait.frequency", 2);
  CHECK(c.is_told("setParameters: this needs the right to command"));
  CHECK(one.controls.asked().empty());
  CHECK(c.call("/cca/stop").empty());
  CHECK(one.controls.was_asked(about::end_run));
}

TEST_CASE("The token comes as a sub-protocol or in a message") {
  opened one;
  client c(one.port());
  CHECK(asked_rights(c) == rights(false, false));
  c.text({{"op", "cca.token"}, {"token", token}});
  CHECK(next_rights(c) == rights(true, false));
  CHECK(one.door.token() == token);
}

TEST_CASE("Three wrong tokens, and the connection is closed") {
  opened one;
  client c(one.port(), "0123456789abcdef0123456789abcdee");
  CHECK(c.is_open);
  CHECK(c.is_told("this is not the token of this door"));
  CHECK(next_rights(c) == rights(false, false));
  c.text({{"op", "cca.token"}, {"token", token.substr(1)}});
  CHECK(c.is_told("this is not the token of this door"));
  CHECK(c.closed_with == 0);
  c.text({{"op", "cca.token"}});
  CHECK(c.is_told("for the last time"));
  CHECK(c.waits([&] { return c.closed_with != 0; }));
  CHECK(c.closed_with == 1008);
  CHECK(c.wire.closes());
}

TEST_CASE("A right token between wrong ones does not open a closed door") {
  opened one;
  client c(one.port());
  for (int i = 0; i < 3; ++i) c.text({{"op", "cca.token"}, {"token", "wrong"}});
  c.text({{"op", "cca.token"}, {"token", token}});
  CHECK(c.wire.closes());
  c.read(1ms);
  for (const auto& one_text : c.texts)
    CHECK_FALSE((one_text["op"] == "cca.rights" && one_text["mayChange"] == true));
}

TEST_CASE("A URL is valid once, and gives the right to command if nobody has it") {
  opened one;
  const std::string url = one.door.one_time_url(), other = one.door.one_time_url();
  const std::string target = url.substr(url.find("/?once="));
  CHECK(url == "ws://127.0.0.1:" + std::to_string(one.port()) + target);
  CHECK(target.size() == 7 + 32);
  client c(one.port(), "", {.target = target});
  CHECK(asked_rights(c)["commands"] == true);
  CHECK(c.call("/cca/pause").empty());
  client again(one.port(), "", {.target = target});
  CHECK(again.is_told("this URL was valid once"));
  CHECK(asked_rights(again) == rights(false, false));
  client second(one.port(), "", {.target = other.substr(other.find("/?once="))});
  CHECK(asked_rights(second) == rights(true, false));  // somebody commands
  client wrong(one.port(), "", {.target = "/?once=" + token});
  CHECK(asked_rights(wrong) == rights(false, false));
  client empty(one.port(), "", {.target = "/?once="});
  CHECK(asked_rights(empty) == rights(false, false));
}

TEST_CASE("One client commands - the others are told who, and wait until it gives back") {
  opened one;
  client a(one.port(), token), b(one.port(), token);
  next_rights(a), next_rights(b);
  CHECK(a.call("/cca/give_command") == "this client does not command");
  CHECK(a.call("/cca/take_command").empty());
  CHECK(a.call("/cca/take_command").empty());  // it has it
  CHECK(next_rights(a) == rights(true, true));
  const json told = b.next("cca.rights");
  CHECK(told["commands"] == false);
  const std::string name = told["commandedBy"];
  CHECK(name.starts_with("127.0.0.1:"));
  CHECK(b.call("/cca/take_command") == name + " commands: it must give the command back first");
  CHECK(b.call("/cca/pause") ==
        "this needs the right to command: " + name + " has it and must give it back first");
  CHECK(b.call("/cca/give_command") == "this client does not command");
  CHECK(b.call("/cca/stop").empty());  // the emergency stop is everybody's who has the token
  CHECK(a.call("/cca/give_command").empty());
  CHECK(b.call("/cca/take_command").empty());
  CHECK(a.call("/cca/pause").find("this needs the right to command") == 0);
  CHECK_FALSE(one.controls.was_asked(about::pause));
}

TEST_CASE("What was held is released when the command is given back") {
  opened one;
  client c(one.port(), token);
  CHECK(c.call("/cca/take_command").empty());
  CHECK(c.call(push, {{"force", 5}}).empty());
  CHECK(c.call("/cca/give_command").empty());
  CHECK(soon([&] { return one.controls.was_asked(about::release, "push"); }));
  CHECK_FALSE(one.controls.was_asked(about::pause));
}

TEST_CASE("What is released by its client is not released again") {
  opened one({.on_lost = cca::when_lost::go_on});
  {
    client c(one.port(), token);
    CHECK(c.call("/cca/take_command").empty());
    CHECK(c.call(push, {{"force", 5}}).empty());
    CHECK(c.call("/cca/command/wave").empty());  // nothing holds it
    CHECK(c.call("/cca/release/push").empty());
  }
  CHECK(soon([&] {
    return !one.controls.noted().empty() &&
           one.controls.noted().back().find("lost its connection") != std::string::npos;
  }));
  std::this_thread::sleep_for(50ms);
  CHECK(one.controls.asked().size() == 3);
}

TEST_CASE(
    "With the connection of the commander, what it held ends, and the program does what it was told at "
    "start") {
  for (const auto on_lost : {cca::when_lost::go_on, cca::when_lost::hold, cca::when_lost::stop}) {
    opened one({.on_lost = on_lost});
    client other(one.port(), token);
    next_rights(other);
    {
      client c(one.port(), token);
      CHECK(c.call("/cca/take_command").empty());
      CHECK(c.call(push, {{"force", 5}}).empty());
      c.wire.reset();  // killed
    }
    CHECK(soon([&] { return one.controls.was_asked(about::release, "push"); }));
    CHECK(other.waits([&] {
      return other.texts.size() >= 2 && other.texts.back()["op"] == "cca.rights" &&
             other.texts.back()["commandedBy"].is_null();
    }));
    std::this_thread::sleep_for(20ms);
    CHECK(one.controls.was_asked(about::pause) == (on_lost == cca::when_lost::hold));
    CHECK(one.controls.was_asked(about::end_run) == (on_lost == cca::when_lost::stop));
    CHECK(other.call("/cca/take_command").empty());
  }
}

TEST_CASE(
    "With the connection of the commander its speed and its single beats end, and given back they stay") {
  opened one;
  client other(one.port(), token);
  const auto commands = [&](client& c) {
    CHECK(c.waits([&] { return c.call("/cca/take_command").empty(); }));
    CHECK(c.call("/cca/speed", {{"factor", 0.25}}).empty());
    CHECK(c.call("/cca/speed", {{"factor", 0.5}}).empty());
    CHECK(c.call("/cca/step", {{"beats", 1000}}).empty());
  };
  {
    client c(one.port(), token);
    commands(c);
    CHECK(c.call("/cca/give_command").empty());
    c.wire.reset();
  }
  std::this_thread::sleep_for(20ms);
  CHECK(one.controls.status().speed == 0.5);
  CHECK_FALSE(one.controls.was_asked(about::end_steps));
  {
    client c(one.port(), token);
    CHECK(c.waits([&] { return c.call("/cca/take_command").empty(); }));
    CHECK(c.call("/cca/speed", {{"factor", 2}}).empty());
    CHECK(c.call("/cca/give_command").empty());
    commands(c);
    c.wire.reset();  // killed
  }
  CHECK(soon([&] { return one.controls.was_asked(about::end_steps); }));
  CHECK(soon([&] { return one.controls.status().speed == 2; }));
  CHECK(other.waits([&] { return other.call("/cca/take_command").empty(); }));
}

TEST_CASE("A start ends a test, and what had come of it is no answer") {
  testable one;
  client c(one.port(), token);
  CHECK(c.call("/cca/take_command").empty());
  CHECK(c.call("/cca/test", sine(0.1)) == "");
  CHECK(one.signal() == "sine");
  CHECK(c.call("/cca/start") == "");
  CHECK(soon([&] { return one.signal() == "off"; }));
  CHECK(c.call("/cca/response") == "/cca/response: the test of servo.reference was ended by a start");
  CHECK(c.call("/cca/test", sine(0.1)) == "");
  ends_with_right(one, c);
}

TEST_CASE("A commander that is silent is lost, and one that answers pings is not") {
  opened one({.on_lost = cca::when_lost::stop}, {.silence = 20000ms, .commander_silence = 2500ms});
  client silent(one.port(), token);
  CHECK(silent.call("/cca/take_command").empty());
  silent.answers_pings = false;
  CHECK(soon([&] { return silent.read(1ms), one.controls.was_asked(about::end_run); }, 6000ms));
  client alive(one.port(), token);
  CHECK(alive.call("/cca/take_command").empty());
  alive.waits([] { return false; }, 4000ms);
  CHECK(alive.call("/cca/pause").empty());
}

TEST_CASE("A commander that reads nothing more is lost, though a write to it is under way") {
  opened one({.on_lost = cca::when_lost::stop}, {.silence = 20000ms, .commander_silence = 1500ms});
  one.channel(1, "/a");
  client stuck(one.port(), token, {}, 4096),
      other(one.port(), token, {.protocols = "foxglove.sdk.v1, cca.v1"});
  CHECK(stuck.waits([&] { return stuck.channel("/a") == 1; }));
  CHECK(stuck.call("/cca/take_command").empty());
  CHECK(stuck.call("/cca/command/push", {{"force", 1}}).empty());
  stuck.subscribe(1, 1);
  stuck.set("gait.frequency", 2.0, "a");
  CHECK(stuck.next("parameterValues")["id"] == "a");
  const auto begin = std::chrono::steady_clock::now();
  std::uint64_t sent = 0;
  CHECK(soon(
      [&] { return one.message(1, ++sent, std::string(10000, 'x')), one.controls.was_asked(about::end_run); },
      4000ms));
  CHECK(std::chrono::steady_clock::now() - begin > 1500ms);
  CHECK(one.controls.was_asked(about::release, "push"));
  CHECK(other.call("/cca/take_command").empty());
  CHECK(stuck.wire.closes());
}

TEST_CASE("A test that a change of parameters has begun ends with the right to command") {
  testable one;
  client c(one.port(), token);
  CHECK(c.call("/cca/take_command").empty());
  c.set("gait.frequency", 2.0);
  c.set("test_servo_reference.signal", "step");
  CHECK(soon([&] { return one.signal() == "step"; }));
  CHECK(c.call("/cca/give_command").empty());
  CHECK(soon([&] { return one.signal() == "off"; }));
  CHECK(c.call("/cca/take_command").empty());
  c.set("test_servo_reference.signal", "sine");
  CHECK(soon([&] { return one.signal() == "sine"; }));
  c.wire.reset();
  CHECK(soon([&] { return one.signal() == "off"; }));
  client later(one.port(), token);
  CHECK(later.call("/cca/take_command").empty());
  later.set("test_servo_reference.signal", "sine");
  CHECK(soon([&] { return one.signal() == "sine"; }));
  later.set("test_servo_reference.signal", "off");
  CHECK(soon([&] { return one.signal() == "off"; }));
  const auto asked = one.controls.asked().size();
  CHECK(later.call("/cca/give_command").empty());
  CHECK(one.controls.asked().size() == asked);  // nothing is left to end
}

TEST_CASE("What an earlier client has begun does not cut the test of the next") {
  testable one;
  one.controls.answers(how::begun);
  {
    client earlier(one.port(), token);
    CHECK(earlier.call("/cca/take_command").empty());
    earlier.set("gait.frequency", 2);
    CHECK(earlier.call("/cca/give_command").empty());  // so the change was heard
  }
  client c(one.port(), token);
  CHECK(c.call("/cca/take_command").empty());
  const auto test = c.send_call("/cca/test", sine(0.1));
  c.text({{"op", "nonsense"}});
  CHECK(c.is_told("nonsense"));
  one.controls.answers(how::done);
  CHECK(c.answer_of(test) == "");
  ends_with_right(one, c);
}

TEST_CASE("A test that waits when the command is given back does not begin") {
  testable one;
  client c(one.port(), token);
  CHECK(c.call("/cca/take_command").empty());
  one.controls.answers(how::busy);
  const auto test = c.send_call("/cca/test", sine(0.1));
  CHECK(c.call("/cca/give_command").empty());
  CHECK(c.answer_of(test) == "/cca/test: it was ended before a beat began it");
  one.controls.answers(how::done);
  CHECK(c.call("/cca/take_command").empty());
  CHECK(c.call("/cca/command/wave").empty());  // all before it has an end
  CHECK(one.signal() == "off");
  for (const auto& asked : one.controls.asked())
    for (const auto& [name, value] : asked.values) CHECK(value.text != "sine");
}

TEST_CASE("Of two tests, the first of which is begun late, each ends with its client's right") {
  testable one;
  client a(one.port(), token), b(one.port(), token);
  CHECK(a.call("/cca/take_command").empty());
  one.controls.answers(how::begun);
  const auto first = a.send_call("/cca/test", sine(0.1));
  CHECK(a.call("/cca/give_command").empty());
  CHECK(b.call("/cca/take_command").empty());
  const auto second = b.send_call("/cca/test", sine(0.2));
  b.text({{"op", "nonsense"}});
  CHECK(b.is_told("nonsense"));
  one.controls.answers(how::done);
  CHECK(a.answer_of(first) == "");
  CHECK(b.answer_of(second) == "");
  ends_with_right(one, b);
}

TEST_CASE("What nobody has begun is not done after its client is lost") {
  opened one;
  one.controls.answers(how::busy);
  {
    client c(one.port(), token);
    CHECK(c.call("/cca/take_command").empty());
    c.send_call("/cca/switch_mode", {{"mode", "walk"}});
    c.set("gait.frequency", 2);
    c.text({{"op", "nonsense"}});
    CHECK(c.is_told("nonsense"));  // so all was heard
    c.wire.reset();
  }
  CHECK(soon([&] {
    return !one.controls.noted().empty() && one.controls.noted().back().find("lost") != std::string::npos;
  }));
  one.controls.answers(how::done);
  std::this_thread::sleep_for(50ms);
  CHECK(one.controls.asked().empty());
}

TEST_CASE("A command that has effect only after its client is lost is released at once") {
  opened one;
  one.controls.answers(how::begun);
  {
    client c(one.port(), token);
    CHECK(c.call("/cca/take_command").empty());
    c.send_call(push, {{"force", 5}});
    c.text({{"op", "nonsense"}});
    CHECK(c.is_told("nonsense"));
    c.wire.reset();
  }
  CHECK(soon([&] {
    return !one.controls.noted().empty() && one.controls.noted().back().find("lost") != std::string::npos;
  }));
  one.controls.answers(how::done);
  CHECK(soon([&] { return one.controls.asked().size() == 2; }));
  CHECK(one.controls.asked()[0].about == about::call);
  CHECK(one.controls.asked()[1].about == about::release);
}

TEST_CASE("Open to other machines, a door is read with the token only") {
  opened one({.address = "0.0.0.0"}, {.greeting_time = 600ms});
  client c(one.port());
  CHECK(c.is_open);
  CHECK(asked_rights(c) == rights(false, false));
  CHECK(c.is_told("reading needs the token, too"));
  c.subscribe(1, 60001);
  CHECK(c.is_told("reading needs the token, too"));
  c.text({{"op", "getParameters"}});
  CHECK(c.is_told("reading needs the token, too"));
  c.wire.send(frame_of(0x82, client::bytes_of_call(1, 1, "{}")));
  CHECK(c.is_told("needs the token"));
  one.channel(1, "/a");
  one.message(1, 99, "x");
  c.read(100ms);
  CHECK(c.samples.empty());
  CHECK(c.times.empty());
  for (const auto& text : c.texts) CHECK((text["op"] == "serverInfo"));
  CHECK(c.waits([&] { return c.closed_with == 1008; }));  // it had its time
  client with(one.port(), token), later(one.port());
  CHECK(with.channel("/cca/status") == 60001);
  CHECK(later.next("advertise", 50ms).is_null());
  later.text({{"op", "cca.token"}, {"token", token}});
  CHECK(later.channel("/cca/status") == 60001);
  std::this_thread::sleep_for(800ms);
  CHECK(later.call("/cca/take_command").empty());  // it stays
  const client by_key(one.port(), "",
                      {.target = one.door.one_time_url().substr(one.door.one_time_url().find("/?"))});
  CHECK(by_key.is_open);
}

TEST_CASE("A token is made at random, or must be a good one") {
  fake_controls controls;
  const cca::detail::door_server a({.port = 0, .tells_where = false}, controls),
      b({.port = 0, .tells_where = false}, controls);
  CHECK(a.token().size() == 32);
  CHECK(a.token().find_first_not_of("0123456789abcdef") == std::string::npos);
  CHECK(a.token() != b.token());
  CHECK(why_no_token({.token = "short"}).find("16 to 256 letters") != std::string::npos);
  CHECK(why_no_token({.token = "0123456789abcdef,x"}).find("16 to 256 letters") != std::string::npos);
  CHECK(why_no_token({.token = token, .token_file = "x"}).find("not both") != std::string::npos);
}

TEST_CASE("The file of a token is this user's alone") {
  const std::string name = "door_token";
  std::remove(name.c_str());
  CHECK(why_no_token({.token_file = name}).find("No such file") != std::string::npos);
  std::ofstream(name) << token << "\n";
  for (const auto& [mode, text] : {std::pair(0644, "644"),
                                   {0640, "640"},
                                   {0604, "604"},
                                   {0660, "660"},
                                   {0620, "620"},
                                   {0601, "601"},
                                   {0610, "610"},
                                   {0444, "444"}}) {
    ::chmod(name.c_str(), static_cast<mode_t>(mode));
    CHECK(why_no_token({.token_file = name}) ==
          "the token's file " + name + " has mode " + text +
              ", so not only its owner has access to it: run `chmod 600 " + name + "`");
  }
  for (const mode_t mode : {0400u, 0700u, 0500u, 0600u}) {
    ::chmod(name.c_str(), mode);
    CHECK(why_no_token({.token_file = name}).empty());
  }
  {
    fake_controls controls;
    const cca::detail::door_server door({.port = 0, .token_file = name, .tells_where = false}, controls);
    CHECK(door.token() == token);
  }
  std::ofstream(name) << "short\n";
  CHECK(why_no_token({.token_file = name}).find("16 to 256 letters") != std::string::npos);
  CHECK(why_no_token({.token_file = "."}).find("no regular file") != std::string::npos);
  const std::string link = "door_token_link";
  std::remove(link.c_str());
  REQUIRE(::symlink(name.c_str(), link.c_str()) == 0);
  CHECK(why_no_token({.token_file = link}).find("can't be opened") != std::string::npos);
  if (::geteuid() == 0) {
    std::ofstream(name) << token << "\n";
    REQUIRE(::chown(name.c_str(), 12345, 12345) == 0);
    CHECK(why_no_token({.token_file = name}).find("belongs to another user") != std::string::npos);
  }
  std::remove(link.c_str());
  std::remove(name.c_str());
}

TEST_CASE("door: a viewer that knows only the protocol hears nothing else, until it asks") {
  opened one;
  client viewer(one.port());
  CHECK(viewer.next("advertiseServices")["op"] == "advertiseServices");
  CHECK(viewer.next("cca.rights", 200ms).is_null());
  viewer.text({{"op", "cca.describe"}});
  CHECK(viewer.next("cca.rights")["mayChange"] == false);
}
