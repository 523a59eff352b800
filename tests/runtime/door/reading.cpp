// What clients of a door read: channels, samples, the time, the status, the log, parameters, the graph.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include <cca/door/network/outbox.hpp>

#include "opened.hpp"

using namespace door_test;

namespace {

json sample_of(client& c, std::uint32_t subscription, const std::string& member) {
  json found;
  c.waits([&] {
    for (const auto& one : c.samples)
      if (one.subscription == subscription && json::parse(one.data).contains(member))
        return found = json::parse(one.data), true;
    return false;
  });
  return found;
}

}  // namespace

TEST_CASE("Channels are told, those that come later too") {
  opened one;
  one.channel(1, "/gait/angles");
  client c(one.port());
  CHECK(c.waits([&] { return c.channel("/gait/angles") == 1; }));
  CHECK(c.channel("/cca/status") == 60001);
  CHECK(c.channel("/cca/log") == 60002);
  one.channel(2, "/later");
  const json more = c.next("advertise")["channels"];
  REQUIRE(more.size() == 1);
  CHECK(more[0] == json{{"id", 2},
                        {"topic", "/later"},
                        {"encoding", "cdr"},
                        {"schemaName", "cca/msg/one"},
                        {"schema", "uint64 beat\n"},
                        {"schemaEncoding", "ros2msg"}});
  one.channel(2, "/later");  // a recording begins again: nothing new
  one.channel(2, "/other");
  CHECK(c.next("unadvertise")["channelIds"] == json::array({2}));
  CHECK(c.next("advertise")["channels"][0]["topic"] == "/other");
}

TEST_CASE("A sample comes with its subscription and its time, and not after the subscription ends") {
  opened one;
  one.channel(7, "/a");
  one.channel(8, "/b");
  client c(one.port());
  CHECK(c.waits([&] { return c.channel("/b") == 8; }));
  c.subscribe(40, 7);
  CHECK(c.waits(
      [&] { return one.message(7, 123456789, "data"), one.message(8, 1, "no"), !c.samples.empty(); }));
  CHECK(c.samples[0].subscription == 40);
  CHECK(c.samples[0].time == 123456789);
  CHECK(c.samples[0].data == "data");
  c.text({{"op", "unsubscribe"}, {"subscriptionIds", {40}}});
  c.text({{"op", "nonsense"}});
  CHECK(c.is_told("does not offer"));  // so all before was heard
  c.samples.clear();
  one.message(7, 5, "late");
  c.read(50ms);
  CHECK(c.samples.empty());
}

TEST_CASE("A client that asks for batches gets many samples in one message, each as it was") {
  opened one;
  for (std::uint16_t i = 1; i <= 3; ++i) one.channel(i, "/a" + std::to_string(i));
  client c(one.port(), "", {.protocols = "foxglove.websocket.v1, cca.batches.v1"});
  client other(one.port(), "", {.protocols = "foxglove.websocket.v1, cca.v1"});
  CHECK(c.head.find("Sec-WebSocket-Protocol: foxglove.websocket.v1\r\n") != std::string::npos);
  CHECK(c.next("cca.rights")["mayChange"] == false);  // it knows what is the door's own
  for (client* each : {&c, &other}) {
    CHECK(each->waits([&] { return each->channel("/a3") == 3; }));
    for (std::uint32_t i = 1; i <= 3; ++i) each->subscribe(40 + i, i);
    each->text({{"op", "nonsense"}});
    CHECK(each->is_told("does not offer"));
  }
  // Data of many lengths, also of none. They wait together, as those of a beat do.
  const auto data = [](std::uint64_t k) { return std::string(k % 300, static_cast<char>('a' + k % 26)); };
  for (std::uint64_t k = 0; k < 3000; ++k) {
    const std::string bytes = data(k);
    one.door.sink().message(static_cast<std::uint16_t>(1 + k % 3), 1000 + k, 0,
                            {reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
  }
  one.door.sink().hand_over();
  for (client* each : {&c, &other}) {
    REQUIRE(each->waits([&] { return each->samples.size() >= 3000; }));
    CHECK(each->samples.size() == 3000);
    bool same = true;
    for (std::uint64_t k = 0; k < 3000; ++k) {
      const auto& s = each->samples[k];
      same = same && s.subscription == 41 + k % 3 && s.time == 1000 + k && s.data == data(k);
    }
    CHECK(same);
  }
  CHECK(c.whole_batches);
  CHECK(c.batches > 0);
  CHECK(c.batches < 60);      // 450 kB, of which about 64 KiB are in one, or what has come until then
  CHECK(other.batches == 0);  // of Foxglove's protocol only
}

TEST_CASE("A slow client of batches loses the oldest samples, whole ones, and is told how many") {
  opened one({}, {.waiting_bytes = 1000});
  one.channel(1, "/a");
  client c(one.port(), "", {.protocols = "foxglove.websocket.v1, cca.batches.v1"});
  CHECK(c.waits([&] { return c.channel("/a") == 1; }));
  c.subscribe(4, 1);
  c.text({{"op", "nonsense"}});
  CHECK(c.is_told("does not offer"));
  for (std::uint64_t k = 1; k <= 1000; ++k) one.door.sink().message(1, k, 0, {});
  one.door.sink().hand_over();
  CHECK(c.is_told("this client is slow: it has lost"));
  CHECK(c.whole_batches);
  CHECK(c.samples.size() >= 1000 / 16);
  CHECK(c.samples.size() < 1000);
  CHECK(c.samples.back().time == 1000);
  bool in_order = true;
  for (std::size_t k = 1; k < c.samples.size(); ++k)
    in_order = in_order && c.samples[k].time > c.samples[k - 1].time;
  CHECK(in_order);
}

TEST_CASE("A channel that is kept gives its last message to who comes later") {
  opened one;
  one.channel(1, "/state", true);
  one.message(1, 10, "loaded");
  one.message(1, 20, "running");
  client c(one.port());
  CHECK(c.waits([&] { return c.channel("/state") == 1; }));
  c.subscribe(3, 1);
  CHECK(c.waits([&] { return c.samples.size() == 1; }));
  CHECK(c.samples[0].data == "running");
  CHECK(c.samples[0].time == 20);
}

TEST_CASE("Wrong subscriptions are refused") {
  opened one({}, {.subscriptions = 2});
  one.channel(1, "/a");
  one.channel(2, "/b");
  client c(one.port());
  CHECK(c.waits([&] { return c.channel("/b") == 2; }));
  c.subscribe(1, 99);
  CHECK(c.is_told("there is no channel 99"));
  c.subscribe(1, 70000);
  CHECK(c.is_told("there is no channel 70000"));
  c.subscribe(1, 1);
  c.subscribe(1, 2);
  CHECK(c.is_told("the subscription 1 is used already"));
  c.subscribe(2, 1);
  CHECK(c.is_told("channel 1 is subscribed already"));
  c.subscribe(2, 2);
  c.subscribe(3, 60001);
  CHECK(c.is_told("at most 2 subscriptions"));
  c.text({{"op", "subscribe"}});
  CHECK(c.is_told("expected a list"));
  c.text({{"op", "subscribe"}, {"subscriptions", {1, "x", nullptr}}});
  CHECK(c.is_told("expected whole numbers id and channelId"));
  c.text({{"op", "subscribe"}, {"subscriptions", json::array({{{"id", -1}, {"channelId", 1}}})}});
  CHECK(c.is_told("expected whole numbers id and channelId"));
  c.text({{"op", "unsubscribe"}, {"subscriptionIds", {9}}});
  CHECK(c.is_told("there is no subscription 9"));
}

TEST_CASE("What the door does not offer is refused with a status") {
  opened one;
  client c(one.port());
  c.wire.send(frame_of(0x81, "no JSON"));
  CHECK(c.is_told("expected an object of JSON with `op`"));
  c.wire.send(frame_of(0x81, "[1]"));
  CHECK(c.is_told("expected an object of JSON with `op`"));
  c.wire.send(frame_of(0x81, "{\"op\":\"\xff\"}"));
  CHECK(c.is_told("expected an object of JSON with `op`"));
  c.text({{"op", "advertise"}});
  CHECK(c.is_told("does not offer \"advertise\""));
  c.wire.send(frame_of(0x82, std::string("\1\0\0\0\0data", 9)));
  CHECK(c.is_told("calls of services only"));
  c.wire.send(frame_of(0x82, ""));
  CHECK(c.is_told("calls of services only"));
  c.wire.send(frame_of(
      0x82, std::string("\2\1\0\0\0\1\0\0\0\xff\0\0\0json", 17)));  // the encoding is longer than the rest
  CHECK(c.is_told("calls of services only"));
}

TEST_CASE("JSON that is too deep is refused, the same in a call") {
  opened one;
  client c(one.port(), token);
  CHECK(c.call("/cca/take_command").empty());
  const std::string deep =
      "{\"op\":\"getParameters\",\"x\":" + std::string(30000, '[') + std::string(30000, ']') + "}";
  c.wire.send(frame_of(0x81, deep));
  CHECK(c.is_told("at most 16 deep"));
  c.wire.send(
      frame_of(0x81, "{\"op\":\"getParameters\",\"x\":" + std::string(15, '[') + std::string(15, ']') + "}"));
  CHECK(c.next("parameterValues")["parameters"].size() == 5);
  c.wire.send(frame_of(0x81, "{\"op\":\"getParameters\",\"x\":\"" + std::string(100, '[') +
                                 "\\\"[\"}"));  // within a text it is none
  CHECK(c.next("parameterValues")["parameters"].size() == 5);
  c.wire.send(
      frame_of(0x82, client::bytes_of_call(c.service("/cca/pause"), 77,
                                           "{\"x\":" + std::string(17, '[') + std::string(17, ']') + "}")));
  CHECK(c.next("serviceCallFailure")["message"].get<std::string>().find("at most 16 deep") !=
        std::string::npos);
  CHECK_FALSE(one.controls.was_asked(fake_controls::about::pause));
}

TEST_CASE("The time of the run is told") {
  opened one;
  one.channel(1, "/a");
  client c(one.port());
  one.message(1, 4000, "x");  // nobody has subscribed, and still
  CHECK(c.waits([&] { return !c.times.empty(); }));
  CHECK(c.times.back() == 4000);
}

TEST_CASE("The status comes ten times a second while somebody reads it") {
  opened one;
  client c(one.port(), token);
  c.subscribe(5, 60001);
  json first = sample_of(c, 5, "state");
  CHECK(first["state"] == "running");
  CHECK(first["period"] == 1000000);
  CHECK(first["environments"][0]["beats"] == 7);
  CHECK(first["commandedBy"].is_null());
  CHECK(first["clients"] == 1);
  CHECK(c.call("/cca/take_command").empty());
  c.samples.clear();
  CHECK(sample_of(c, 5, "state")["commandedBy"].is_string());
  c.samples.clear();
  CHECK(c.waits([&] { return c.samples.size() >= 5; }, 1500ms));
  c.text({{"op", "unsubscribe"}, {"subscriptionIds", {5}}});
  c.read(200ms);
  const auto before = one.controls.status().beat;
  std::this_thread::sleep_for(300ms);
  CHECK(one.controls.status().beat == before + 1);  // nobody reads it, so nobody asks
  // What is known by then is old: the first look only asks for a new one.
  c.samples.clear();
  c.subscribe(5, 60001);
  CHECK(sample_of(c, 5, "state")["beat"].get<std::int64_t>() >= before + 3);
}

TEST_CASE("What the twin of a client finds is in the status, by the token, and goes with the client") {
  opened one;
  client c(one.port());
  c.subscribe(5, 60001);
  const auto twins = [&] {
    c.samples.clear();
    return sample_of(c, 5, "state")["twins"];
  };
  CHECK(twins().empty());
  {
    client watcher(one.port(), token);
    watcher.text({{"op", "cca.twin"}, {"says", "the same, bit for bit: 5 beats"}});
    CHECK(soon([&] { return !twins().empty(); }));
    CHECK(twins().size() == 1);
    CHECK(twins()[0]["says"] == "the same, bit for bit: 5 beats");
    CHECK(twins()[0]["client"].get<std::string>().starts_with("127.0.0.1:"));
    watcher.text({{"op", "cca.twin"}, {"says", std::string(2000, 'x')}});
    CHECK(soon([&] { return twins()[0]["says"].get<std::string>() == std::string(400, 'x'); }));
    watcher.text({{"op", "cca.twin"}, {"says", ""}});
    CHECK(soon([&] { return twins().empty(); }));
    watcher.text({{"op", "cca.twin"}, {"says", "the same"}});
    CHECK(soon([&] { return !twins().empty(); }));
  }
  CHECK(soon([&] { return twins().empty(); }));
  c.text({{"op", "cca.twin"}, {"says", "the same"}});
  CHECK(c.is_told("cca.twin: this needs the token"));
  CHECK(twins().empty());
}

TEST_CASE("The log tells who has changed what, to who comes later too") {
  opened one;
  client c(one.port(), token);
  CHECK(c.call("/cca/take_command").empty());
  c.set("gait.frequency", 2.5, "a");
  CHECK(c.next("parameterValues")["id"] == "a");
  c.set("gait.frequency", 99);
  CHECK(c.is_told("99"));
  client later(one.port());
  later.subscribe(1, 60002);
  CHECK(later.waits([&] { return later.samples.size() == 3; }));
  const auto what = [&](std::size_t i) {
    return json::parse(later.samples.at(i).data)["what"].get<std::string>();
  };
  CHECK(what(0) == "takes the command");
  CHECK(what(1) == "set gait.frequency from 1.5 to 2.5 Hz");
  CHECK(what(2).starts_with("refused: set: gait.frequency = 99"));
  CHECK(json::parse(later.samples[1].data)["client"].get<std::string>().starts_with("127.0.0.1:"));
  CHECK(json::parse(later.samples[1].data)["time"] > 1.6e9);
  const auto notes = one.controls.noted();  // changes alone
  REQUIRE(notes.size() == 2);
  CHECK(notes[1].ends_with("set gait.frequency from 1.5 to 2.5 Hz"));
}

TEST_CASE("Refusals don't drive changes out of the log, nor the other way round") {
  opened one;
  client c(one.port(), token), stranger(one.port());
  CHECK(c.call("/cca/take_command").empty());
  for (int i = 0; i < 100; ++i) stranger.set("gait.frequency", i);
  stranger.text({{"op", "nonsense"}});
  CHECK(stranger.is_told("nonsense"));
  const auto lines = [&] {
    client later(one.port());
    later.subscribe(1, 60002);
    later.text({{"op", "nonsense"}});
    CHECK(later.is_told("nonsense"));
    later.waits([&] { return !later.samples.empty() && later.samples.back().data.empty(); }, 50ms);
    std::vector<std::string> all;
    for (const auto& sample : later.samples) all.push_back(json::parse(sample.data)["what"]);
    return all;
  };
  const auto first = lines();
  REQUIRE(first.size() == 17);
  CHECK(first[0] == "takes the command");
  CHECK(first[16].starts_with("refused: set: this needs the token"));
  for (int i = 0; i < 60; ++i) c.set("gait.frequency", 1 + i / 60.0, "a");
  CHECK(c.waits([&] { return c.texts.size() > 60; }));
  const auto second = lines();
  CHECK(second.size() == 64);
  CHECK(second[0].starts_with("refused: set: "));
  CHECK(second[15].starts_with("refused: set: "));
  CHECK(second[16].starts_with("set gait.frequency from "));
}

TEST_CASE("A recording that can't be written any more is told once, to those who may read, and logged") {
  opened one;
  client c(one.port());
  one.controls.recording_fails("f.mcap can't be written: No space left on device");
  CHECK(c.is_told("the recording is incomplete: f.mcap can't be written: No space left on device", 1000ms));
  CHECK_FALSE(c.is_told("the recording is incomplete", 300ms));
  CHECK(c.channel("/cca/log") == 60002);
  c.subscribe(1, 60002);
  c.subscribe(2, 60001);
  CHECK(sample_of(c, 1, "what")["what"] ==
        "the recording is incomplete: f.mcap can't be written: No space left on device");
  CHECK(sample_of(c, 2, "state")["recording_problem"] == "f.mcap can't be written: No space left on device");
  one.controls.recording_fails("");
  CHECK_FALSE(c.is_told("the recording is incomplete", 300ms));
  one.controls.recording_fails("f.mcap can't be written: No space left on device");
  CHECK(c.is_told("the recording is incomplete", 1000ms));
}

TEST_CASE("Parameters are read, all or by name") {
  opened one;
  client c(one.port());
  c.text({{"op", "getParameters"}, {"parameterNames", json::array()}, {"id", "all"}});
  const json all = c.next("parameterValues");
  CHECK(all["id"] == "all");
  REQUIRE(all["parameters"].size() == 5);
  CHECK(all["parameters"][0] == json{{"name", "gait.frequency"}, {"value", 1.5}, {"type", "float64"}});
  CHECK(all["parameters"][1] == json{{"name", "gait.steps"}, {"value", 3}});
  CHECK(all["parameters"][2]["value"] == true);
  CHECK(all["parameters"][3]["value"] == "trot");
  CHECK(all["parameters"][4] ==
        json{{"name", "gait.gains"}, {"value", {1.0, 2.0, 3.0}}, {"type", "float64_array"}});
  c.text({{"op", "getParameters"}, {"parameterNames", {"gait.kind", "no.such"}}});
  CHECK(c.next("parameterValues")["parameters"].size() == 1);
  CHECK(c.is_told("there is no parameter \"no.such\""));
}

TEST_CASE("Parameters are told where they change, by a client or by the program") {
  opened one;
  client c(one.port()), other(one.port());
  c.text({{"op", "subscribeParameterUpdates"}, {"parameterNames", {"gait.steps"}}});
  other.text({{"op", "subscribeParameterUpdates"}, {"parameterNames", {"gait.kind"}}});
  CHECK(c.next("parameterValues")["parameters"].size() == 1);  // as it is
  CHECK(other.next("parameterValues")["parameters"].size() == 1);
  one.controls.change("gait.steps", {.what = fake_controls::value::kind::integer, .integer = 5});
  CHECK(c.next("parameterValues")["parameters"] == json::array({{{"name", "gait.steps"}, {"value", 5}}}));
  CHECK(other.next("parameterValues", 700ms).is_null());
  c.text({{"op", "unsubscribeParameterUpdates"}, {"parameterNames", {"gait.steps"}}});
  c.text({{"op", "nonsense"}});
  CHECK(c.is_told("nonsense"));
  one.controls.change("gait.steps", {.what = fake_controls::value::kind::integer, .integer = 6});
  CHECK(c.next("parameterValues", 1200ms).is_null());
}

TEST_CASE("The name of a parameter that is subscribed to has an end") {
  opened one;
  client c(one.port());
  c.text({{"op", "subscribeParameterUpdates"}, {"parameterNames", {std::string(256, 'x')}}});
  CHECK_FALSE(c.is_told("a name has at most", 100ms));
  c.text({{"op", "subscribeParameterUpdates"}, {"parameterNames", {std::string(257, 'x')}}});
  CHECK(c.is_told("subscribeParameterUpdates: a name has at most 256 bytes"));
}

TEST_CASE("A message of many wrong items has a few answers") {
  opened one;
  client c(one.port());
  json ids = json::array(), names = json::array(), pairs = json::array();
  for (int i = 0; i < 1000; ++i) {
    ids.push_back(i), names.push_back("x" + std::to_string(i));
    pairs.push_back({{"id", i}, {"channelId", 40000}});
  }
  const auto statuses = [&](const json& message) {
    c.texts.clear();
    c.text(message);
    c.text({{"op", "nonsense"}});
    const auto is_last = [](const json& one) {
      return one["op"] == "status" && one["message"].get<std::string>().ends_with("\"nonsense\"");
    };
    CHECK(c.waits([&] { return std::any_of(c.texts.begin(), c.texts.end(), is_last); }));
    return std::count_if(c.texts.begin(), c.texts.end(),
                         [](const json& one) { return one["op"] == "status"; }) -
           1;
  };
  CHECK(statuses({{"op", "subscribe"}, {"subscriptions", pairs}}) == 8);
  CHECK(statuses({{"op", "unsubscribe"}, {"subscriptionIds", ids}}) == 8);
  CHECK(statuses({{"op", "getParameters"}, {"parameterNames", names}}) == 8);
}

TEST_CASE("Parameters that can't be read are refused after a while") {
  opened one({}, {.taken_time = 200ms});
  one.controls.answers(fake_controls::how::busy);
  client c(one.port());
  c.text({{"op", "getParameters"}});
  CHECK(c.is_told("can't be read: the loop has not begun a beat since"));
  c.text({{"op", "getParameters"}});
  std::this_thread::sleep_for(50ms);
  one.controls.answers(fake_controls::how::done);
  CHECK(c.next("parameterValues")["parameters"].size() == 5);
}

TEST_CASE("Of what clients ask for and can't have yet there is an end") {
  opened one({}, {.subscriptions = 3, .requests = 2});
  one.controls.answers(fake_controls::how::busy);
  client c(one.port());
  for (int i = 0; i < 3; ++i) c.text({{"op", "getParameters"}});
  CHECK(c.is_told("too many clients ask for parameters"));
  one.controls.answers(fake_controls::how::done);
  CHECK(c.next("parameterValues")["parameters"].size() == 5);
  c.text({{"op", "subscribeParameterUpdates"}, {"parameterNames", {"a", "b", "c", "d"}}});
  CHECK(c.is_told("subscribeParameterUpdates: at most 3"));
}

TEST_CASE("The program describes itself") {
  opened one;
  one.door.sink().metadata("cca.architecture", {{"name", "fake"}});
  client c(one.port());
  json d;
  CHECK(soon([&] {
    return c.text({{"op", "cca.describe"}}), d = c.next("cca.description"),
                                             d["metadata"].contains("cca.architecture");
  }));
  CHECK(d["program"] == "fake");
  CHECK(d["modes"] == json::array({"walk", "stand"}));
  CHECK(d["wires"] == json::array({json::array({"gait.angles", "robot.commands"})}));
  CHECK(d["commands"][0]["name"] == "push");
  CHECK(d["commands"][0]["held"] == true);
  CHECK(d["commands"][0]["arguments"][0] ==
        json{{"name", "force"}, {"unit", "N"}, {"value", 0.0}, {"lower", -50.0}, {"upper", 50.0}});
  CHECK(d["parameters"][0] == json{{"path", "gait.frequency"},
                                   {"kind", "number"},
                                   {"value", 1.5},
                                   {"unit", "Hz"},
                                   {"lower", 0.1},
                                   {"upper", 5.0},
                                   {"choices", json::array()}});
  CHECK(d["parameters"][3]["choices"] == json::array({"trot", "walk"}));
}

TEST_CASE("The graph is told") {
  opened one;
  client c(one.port());
  c.text({{"op", "subscribeConnectionGraph"}});
  const json graph = c.next("connectionGraphUpdate");
  CHECK(graph["publishedTopics"] == json::array({{{"name", "/gait/angles"}, {"publisherIds", {"gait"}}}}));
  CHECK(graph["subscribedTopics"] == json::array({{{"name", "/gait/angles"}, {"subscriberIds", {"robot"}}}}));
  CHECK(graph["advertisedServices"].size() == 20);
}

TEST_CASE("A slow client loses the oldest, is told how many, and keeps the last of what is kept") {
  opened one({}, {.waiting_bytes = 100000, .waiting_messages = 100});
  one.channel(1, "/fast");
  one.channel(2, "/state", true);
  client slow(one.port(), "", {}, 4096), quick(one.port());
  CHECK(slow.waits([&] { return slow.channel("/state") == 2; }));
  CHECK(quick.waits([&] { return quick.channel("/state") == 2; }));
  for (client* c : {&slow, &quick}) {
    c->subscribe(1, 1);
    c->subscribe(2, 2);
    c->text({{"op", "nonsense"}});
    CHECK(c->is_told("nonsense"));
  }
  one.message(2, 1, "state 1");
  const std::string large(3000, 'x');
  int sent = 0;
  for (; sent < 2000; ++sent) {
    one.message(1, static_cast<std::uint64_t>(sent), large);
    if (sent == 1000) one.message(2, 2, "state 2");
    quick.waits(
        [&] { return quick.samples.size() >= static_cast<std::size_t>(sent + (sent >= 1000 ? 3 : 2)); });
  }
  CHECK(quick.samples.size() == 2002);  // the one beside it loses nothing
  CHECK(slow.is_told("this client is slow: it has lost "));
  const auto has = [&](auto&& holds) { return std::any_of(slow.samples.begin(), slow.samples.end(), holds); };
  CHECK(slow.waits([&] {
    return has([](const auto& s) { return s.data == "state 2"; }) &&
           has([](const auto& s) { return s.time == 1999; });
  }));
  CHECK(slow.samples.size() < 2000);
  std::uint64_t last = 0;
  for (const auto& s : slow.samples)
    if (s.subscription == 1) {
      CHECK(s.time >= last);
      last = s.time;
    }
  CHECK(last == 1999);  // the newest came
  CHECK_FALSE(quick.is_told("slow", 10ms));
}

TEST_CASE("What a client that was slow has needed is given back when it has read it") {
  const cca::detail::door_limits limits;
  cca::detail::door_network::outbox out(limits, false);
  const std::string data(120, 'x');
  std::string to;
  for (int burst = 0; burst < 3; ++burst) {
    for (int i = 0; i < 10'000; ++i) out.sample([](std::uint16_t) { return false; }, 1, 1, 1, data);
    CHECK(out.holds() > 1'000'000);
    std::size_t read = 0;
    while (out.take(to)) read += to.size();
    CHECK(read > 1'000'000);
    CHECK(out.holds() < 300'000);
    CHECK(out.answer(cca::detail::door_network::frame_kind::text, std::string(1'000'000, 'y')));
    while (out.take(to)) {}
    CHECK(to.capacity() < 300'000);
  }
}

TEST_CASE("What the recording's thread hands over is bounded, and what is lost is told") {
  cca::detail::door_limits limits;
  limits.handed_over = 5000;
  opened one({}, limits);
  one.channel(1, "/a");
  client c(one.port());
  CHECK(c.waits([&] { return c.channel("/a") == 1; }));
  c.subscribe(1, 1);
  c.text({{"op", "nonsense"}});
  CHECK(c.is_told("nonsense"));
  const std::string data(1000, 'x');
  for (std::uint64_t i = 0; i < 50; ++i)  // without flush: all in one hand
    one.door.sink().message(1, i, i, {reinterpret_cast<const unsigned char*>(data.data()), data.size()});
  one.door.sink().hand_over();
  CHECK(c.is_told("it has lost 46 messages"));
  CHECK(c.samples.size() == 4);
}
