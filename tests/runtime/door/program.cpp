// Programs with `--door`: a graph, a deployment, and cca::door in a program of one's own.
#include <doctest/doctest.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <string>
#include <thread>

#include <cca/deployment.hpp>
#include <cca/door.hpp>
#include <cca/main.hpp>
#include <cca/record.hpp>

#include "../programs/child.hpp"
#include "../record/graphs.hpp"
#include "client.hpp"
#include "where_in.hpp"

using namespace record_test;
using door_test::client;
using door_test::json;
using door_test::where;
using door_test::where_in;
using programs_test::child;

namespace {

struct graph : walking<> {};
struct split : cca::deployment<graph, cca::environment<"all", cca::other_nodes>>, cca::recordable {};

template <class Architecture>
struct program : cca::robot_program<Architecture> {
  using controller_type = typename cca::robot_program<Architecture>::controller_type;
  program() {
    this->settings.seconds = 60;
    this->settings.quiet = true;
    this->offers.push_back({.name = "push",
                            .arguments = {{"forward", 1, -5, 5, "N"}},
                            .begin = [](controller_type&, auto n) { tell("pushed " + std::to_string(n[0])); },
                            .end = [](controller_type&) { tell("released"); }});
  }
  void started(controller_type&) override { tell("started"); }
  static void tell(const std::string& what) {
    std::fputs((what + "\n").c_str(), stdout);
    std::fflush(stdout);
  }
};

}  // namespace

TEST_CASE_TEMPLATE("door: a program is looked at, tuned, pushed, paused and stopped",
                   Architecture,
                   graph,
                   split) {
  child walk(cca::robot_main<program<Architecture>>, {"--door", "0"});
  walk.wait_for("started");
  const where at = where_in(walk.out + walk.err);
  client seen(at.port), other(at.port, at.token);
  REQUIRE(seen.is_open);
  seen.subscribe(1, seen.channel("/limits/safe"));
  seen.subscribe(2, seen.channel("/cca/parameters/filter"));
  CHECK(seen.waits([&] { return seen.samples.size() > 100; }));
  CHECK(seen.call("/cca/pause").find("token") != std::string::npos);
  CHECK(other.call("/cca/pause").find("take_command") != std::string::npos);
  CHECK(other.call("/cca/take_command") == "");
  other.set("filter.gain", 0.25, "set");
  CHECK(other.next("parameterValues")["parameters"][0]["value"] == 0.25);
  CHECK(other.call("/cca/command/push", {{"forward", 2}}) == "");
  walk.wait_for("pushed 2");
  CHECK(other.call("/cca/release/push") == "");
  walk.wait_for("released");
  CHECK(other.call("/cca/pause") == "");
  other.set("filter.gain", 0.5, "paused");
  CHECK(other.next("parameterValues")["parameters"][0]["value"] == 0.5);
  CHECK(other.call("/cca/step", {{"beats", 2}}) == "");
  CHECK(other.call("/cca/go_on") == "");
  // Where beats are a second apart, requests are taken between them.
  CHECK(other.call("/cca/speed", {{"factor", 0.001}}) == "");
  const auto begin = std::chrono::steady_clock::now();
  for (int n = 0; n < 8; ++n) {
    other.set("filter.gain", 0.5 + 0.01 * n, "slow");
    CHECK(other.next("parameterValues")["parameters"][0]["value"] == 0.5 + 0.01 * n);
  }
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(4));
  CHECK(other.call("/cca/speed", {{"factor", 0.5}}) == "");
  CHECK(other.call("/cca/command/push") == "");
  CHECK(other.call("/cca/stop") == "");
  walk.wait_for("released");
  CHECK(walk.code() == 0);
}

TEST_CASE_TEMPLATE("door: a signal in a pause ends a program, and no other process has",
                   Architecture,
                   graph,
                   split) {
  child walk(cca::robot_main<program<Architecture>>, {"--door", "0"});
  walk.wait_for("started");
  const where at = where_in(walk.out + walk.err);
  client other(at.port, at.token);
  CHECK(other.call("/cca/take_command") == "");
  CHECK(other.call("/cca/pause") == "");
  walk.send(SIGTERM);
  CHECK(walk.code() == 143);
  CHECK(walk.err.find("another process") == std::string::npos);
}

TEST_CASE("door: a program waits for `go on`, idles meanwhile, and records from then on") {
  const record_test::temporary_file kept("kept");
  child walk(cca::robot_main<program<graph>>,
             {"--door", "0", "--paused", "--seconds", "0.2", "--record", kept.path});
  walk.wait_for_error("waits to be told to go on: type g");
  const where at = where_in(walk.out + walk.err);
  client other(at.port, at.token);
  CHECK(other.call("/cca/take_command") == "");
  other.set("filter.gain", 0.5, "set");
  CHECK(other.next("parameterValues")["parameters"][0]["value"] == 0.5);
  CHECK(walk.out.find("started") == std::string::npos);
  CHECK(other.call("/cca/go_on") == "");
  walk.wait_for("started");
  CHECK(walk.code() == 0);
  const auto played = cca::recording::replay<graph>(kept.path);
  CHECK(played);
  CHECK(played.beats == 200);
}

TEST_CASE("door: a program that waits ends at a signal and at a stop") {
  child walk(cca::robot_main<program<graph>>, {"--door", "0", "--paused"});
  walk.wait_for_error("waits to be told to go on: type g");
  const where at = where_in(walk.out + walk.err);
  client other(at.port, at.token);
  SUBCASE("a stop through the door") {
    CHECK(other.call("/cca/stop") == "");
    CHECK(walk.code() == 0);
  }
  SUBCASE("a signal") {
    walk.send(SIGTERM);
    CHECK(walk.code() == 143);
  }
}

TEST_CASE("door: what happens when the one who commands is gone") {
  const record_test::temporary_file kept("kept");
  std::string said;
  const auto run = [&](const char* what) {
    child walk(cca::robot_main<program<graph>>, {"--door", "0", "--on-lost", what, "--record", kept.path});
    walk.wait_for("started");
    const where at = where_in(walk.out + walk.err);
    client looks(at.port, at.token);
    {
      client commands(at.port, at.token);
      CHECK(commands.call("/cca/take_command") == "");
      CHECK(commands.call("/cca/command/push") == "");
      walk.wait_for("pushed");
      commands.wire.reset();
    }
    walk.wait_for("released");
    if (std::string(what) == "stop") {
      const int code = walk.code();
      said = walk.err;
      return code;
    }
    CHECK(door_test::soon([&] { return looks.call("/cca/take_command").empty(); }));
    looks.subscribe(1, looks.channel("/cca/status"));
    const bool holds = std::string(what) == "hold";
    CHECK(looks.waits([&] {
      for (const auto& one : looks.samples)
        if (json::parse(one.data)["is_paused"] == holds) return true;
      looks.samples.clear();
      return false;
    }));
    CHECK(looks.call("/cca/stop") == "");
    const int code = walk.code();
    said = walk.err;
    return code;
  };
  const auto noted = [&] {
    cca::recording::mcap_reader read(kept.path);
    for (cca::recording::mcap_message m; read.next(m);) {}
    for (const auto& [name, entries] : read.metadata())
      if (name == "cca.program" && entries.contains("ended")) return entries.at("ended");
    return std::string("nothing");
  };
  const std::string lost = " lost its connection while it commanded, which has ended the run after ";
  const std::string told = " has ended the run through the door after ";
  for (const char* const what : {"stop", "hold", "go-on"}) {
    CAPTURE(what);
    CHECK(run(what) == 0);
    CAPTURE(said);
    const bool is_lost = std::string(what) == "stop";
    CHECK((said.find("walk: 127.0.0.1:") != std::string::npos));
    CHECK((said.find(lost) != std::string::npos) == is_lost);
    CHECK((said.find(told) != std::string::npos) == !is_lost);
    CHECK(said.find(noted()) != std::string::npos);
  }
}

TEST_CASE("door: an option that is wrong is refused in words, and nothing runs") {
  const auto refused = [](std::vector<std::string> words) {
    child walk(cca::robot_main<program<graph>>, std::move(words));
    CHECK(walk.code() == 2);
    return walk.err;
  };
  CHECK(refused({"--door", "70000"}).find("expected a whole number from 0 to 65535") != std::string::npos);
  CHECK(refused({"--on-lost", "panic"}).find("expected stop, hold or go-on") != std::string::npos);
  CHECK(refused({"--door-address", "0.0.0.0"}).find("open a door") != std::string::npos);
  CHECK(refused({"--door-origin", "https://lab.example"}).find("open a door") != std::string::npos);
  CHECK(refused({"--on-lost", "hold"}).find("--on-lost: open a door, by --door") != std::string::npos);
  CHECK(refused({"--door", "0", "--twin", "/nowhere/x.wasm"})
            .find("--twin, or door_settings::twin: the file /nowhere/x.wasm") != std::string::npos);
  CHECK(refused({"--door", "0", "--door-origin", "https://lab.example/"}).find("is no address of a page") !=
        std::string::npos);
  CHECK(refused({"--door", "0", "--door-token", "/nowhere/token"}).find("/nowhere/token") !=
        std::string::npos);
}

namespace {

// [door]
[[maybe_unused]] void look_at(
    cca::controller<graph>& c) {      // struct graph : cca::graph<...>, cca::recordable {};
  cca::door door(c, {.port = 8765});  // says where it is, and the token
  c.run(cca::for_<10>{}, cca::at_wall_clock(), door);
}
// [door end]

}  // namespace

TEST_CASE("door: in a program of one's own") {
  cca::controller<graph> c;
  c.load();
  c.start();
  std::int64_t seen = 0;
  {
    cca::door door(c, {.port = 0, .tells_where = false});
    CHECK_THROWS_AS(cca::recording::recorder(c, "/dev/null"), cca::refused);
    std::thread window([&] {
      client looks(door.port(), door.token());
      looks.subscribe(1, looks.channel("/swing/angles"));
      CHECK(looks.waits([&] { return looks.samples.size() > 50; }));
      seen = static_cast<std::int64_t>(looks.samples.size());
      CHECK(looks.call("/cca/stop") == "");
    });
    CHECK(door.ended_by() == "");
    c.run(cca::for_<30>{}, cca::at_wall_clock(), door);
    window.join();
    CHECK(door.ended_by().ends_with(" has ended the run through the door"));
  }
  CHECK(seen > 50);
  CHECK(c.beat_index() < 30'000);
  const std::int64_t k = c.beat_index();
  CHECK(c.step());  // nobody looks any more
  CHECK(c.beat_index() == k + 1);
}

TEST_CASE("door: in a deployment each environment takes its part between two of its beats") {
  cca::deployed<split> d;
  d.load();
  d.start();
  cca::door door(d, {.port = 0, .tells_where = false});
  std::thread window([&] {
    client looks(door.port(), door.token());
    looks.subscribe(1, looks.channel("/swing/angles"));
    CHECK(looks.waits([&] { return looks.samples.size() > 50; }));
    CHECK(looks.call("/cca/take_command") == "");
    looks.set("filter.gain", 0.125, "set");
    CHECK(looks.next("parameterValues")["parameters"][0]["value"] == 0.125);
    CHECK(looks.call("/cca/pause") == "");
    CHECK(looks.call("/cca/go_on") == "");
    CHECK(looks.call("/cca/stop") == "");
  });
  d.run(cca::for_<30>{}, cca::at_wall_clock(), door);
  window.join();
  CHECK(d.get<"filter">().p.gain == 0.125);
}
