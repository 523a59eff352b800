// A fault that does not end a program: it is held until somebody resumes, starts anew, or ends the program.
#include <doctest/doctest.h>

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include <cca/deployment.hpp>
#include <cca/door.hpp>
#include <cca/main.hpp>
#include <cca/modes.hpp>

#include "../programs/child.hpp"
#include "client.hpp"
#include "where_in.hpp"

using door_test::client;
using door_test::json;
using door_test::where_in;
using programs_test::child;

namespace {

struct heat : cca::space<cca::number, cca::axes<cca::x>, cca::rate<1000>> {};

// A motor that is too hot above 80: its own heat, and what a parameter adds.
struct motor {
  auto sense() -> cca::out<"heat", heat> { return own; }
  void act(cca::in<"more", heat> more) { own = more[cca::x{}]; }
  void on_start() { own = 20, say("on"); }
  void on_stop() { say("off"); }
  void on_fault() { say("braked"); }
  void on_idle() {
    if (++idles == 20) say("idles");
  }
  static void say(const char* what) {
    std::printf("%s\n", what);
    std::fflush(stdout);
  }
  double own = 20;
  int idles = 0;
};
struct guard {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, more), (double, grows));
  };
  parameters p{0, 0};
  auto process(cca::in<"heat", heat> now) -> std::tuple<cca::out<"more", heat>, cca::fault> {
    const double own = now[cca::x{}] + p.grows;
    hottest = own;
    return {own, own + p.more > 80 ? cca::fault("the motor is too hot") : cca::fault()};
  }
  cca::cause cause() const {
    if (hottest + p.more > 80) return {"hotter than 80 degrees: let it cool", 7};
    return {};
  }
  double hottest = 0;
};

struct hot : cca::graph<cca::rate<1000>,
                        cca::node<"guard", guard>,
                        cca::node<"motor", motor>,
                        cca::wire<"motor.heat", "guard.heat">,
                        cca::wire<"guard.more", "motor.more">>,
             cca::recordable {};
struct split : cca::deployment<hot, cca::environment<"all", cca::other_nodes>>, cca::recordable {};
struct careful : cca::graph<cca::rate<1000>,
                            cca::node<"guard", guard>,
                            cca::node<"motor", motor>,
                            cca::wire<"motor.heat", "guard.heat">,
                            cca::wire<"guard.more", "motor.more">> {};
struct ways : cca::modes<cca::mode<"bold", careful>, cca::mode<"calm", careful>>, cca::recordable {};

struct thoughtful : cca::graph<cca::rate<1000>,
                               cca::node<"guard", guard>,
                               cca::node<"motor", motor>,
                               cca::wire<"motor.heat", "guard.heat", cca::delayed<1>>,
                               cca::wire<"guard.more", "motor.more", cca::delayed<1>>> {};
struct two_processes : cca::deployment<thoughtful,
                                       cca::environment<"body", cca::nodes<"motor">>,
                                       cca::environment<"mind", cca::other_nodes>,
                                       cca::tolerate<1000>>,
                       cca::recordable {};

template <class Architecture>
struct program : cca::robot_program<Architecture> {
  using controller_type = typename cca::robot_program<Architecture>::controller_type;
  program() {
    this->settings.seconds = 60;
    this->settings.quiet = true;
    this->offers.push_back({.name = "push",
                            .begin = [](controller_type&, auto) { motor::say("pushed"); },
                            .end = [](controller_type&) { motor::say("released"); }});
  }
  void started(controller_type&) override { motor::say("started"); }
  void rests(controller_type&) override {
    if (++rested == 20) motor::say("rests");
  }
  int rested = 0;
};

using words = std::vector<std::string>;
words holding(const words& more = {}) {
  words all{"--door", "0", "--on-fault", "hold"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

// The next status of which this holds; null if none comes. It is subscribed as 9.
json status_of(client& user, const std::function<bool(const json&)>& holds) {
  json found;
  user.samples.clear();
  user.waits([&] {
    for (const auto& one : user.samples)
      if (one.subscription == 9 && holds(json::parse(one.data))) return found = json::parse(one.data), true;
    user.samples.clear();
    return false;
  });
  return found;
}

// A program whose motor a client that commands can heat.
template <class Architecture = hot>
struct heated {
  explicit heated(const words& options = holding(), bool waits_for_start = true)
      : walk(cca::robot_main<program<Architecture>>, options), user(at(waits_for_start)) {
    REQUIRE(user.is_open);
    REQUIRE(user.call("/cca/take_command") == "");
    user.subscribe(9, user.channel("/cca/status"));
  }
  void set(const std::string& name, double value) {
    user.set(name, value, "set");
    CHECK(user.next("parameterValues")["parameters"][0]["value"] == value);
  }
  void overheat() {
    set("guard.more", 70);
    walk.wait_for_error("holds after the fault");
  }
  void cool() { set("guard.more", 0); }
  json status(const std::function<bool(const json&)>& holds) { return status_of(user, holds); }
  json status(const std::string& state) {
    return status([&](const json& now) { return now["state"] == state; });
  }
  std::size_t count(const std::string& what) const {
    std::size_t n = 0;
    for (auto at = walk.out.find(what); at != walk.out.npos; at = walk.out.find(what, at + 1)) ++n;
    return n;
  }

  child walk;
  client user;

private:
  client at(bool waits_for_start) {
    if (waits_for_start) walk.wait_for("started");
    else walk.wait_for_error("waits to be told");
    const auto found = where_in(walk.out + walk.err);
    return client(found.port, found.token);
  }
};

}  // namespace

TEST_CASE_TEMPLATE(
    "door: a fault is held, its cause is told, and what is mended goes on", Architecture, hot, split, ways) {
  heated<Architecture> r;
  CHECK(r.user.call("/cca/resume") == "resume: nothing has faulted");
  r.overheat();
  r.walk.wait_for("braked");
  const json faulted = r.status("faulted");
  CHECK(faulted["fault"] == "the motor is too hot");
  CHECK(faulted["fault_path"] == "guard");
  REQUIRE(faulted["causes"].size() == 1);
  CHECK(faulted["causes"][0].template get<std::string>().find("let it cool") != std::string::npos);
  CHECK(r.walk.err.find("fault in `guard`") != std::string::npos);
  r.walk.wait_for("idles");
  r.walk.wait_for("rests");
  const auto beat = faulted["beat"].template get<std::int64_t>();
  CHECK(r.status("faulted")["beat"] == beat);  // there is no beat
  r.cool();
  CHECK(r.user.call("/cca/resume") == "");
  const json runs = r.status([](const json& now) { return now["state"] == "running" && now["fault"] == ""; });
  CHECK(runs["beat"].template get<std::int64_t>() > beat);
  CHECK(runs["fault_path"] == "");
  CHECK(runs["causes"].empty());
  CHECK(r.count("started") == 1);  // it has gone on
  CHECK(r.user.call("/cca/stop") == "");
  CHECK(r.walk.code() == 1);  // there was a fault
  CHECK(r.count("off") == 1);
}

TEST_CASE_TEMPLATE("door: while the cause is there, it is not resumed, and the reason is told",
                   Architecture,
                   hot,
                   split,
                   ways) {
  heated<Architecture> r;
  r.overheat();
  for (int i = 0; i < 3; ++i)
    CHECK(r.user.call("/cca/resume") == "it faults in its first beat: `guard`: the motor is too hot");
  CHECK(r.status("faulted")["fault"] == "the motor is too hot");
  CHECK(r.user.call("/cca/start") == "it faults in its first beat: `guard`: the motor is too hot");
  r.cool();
  CHECK(r.user.call("/cca/resume") == "");
  CHECK(r.user.call("/cca/stop") == "");
  CHECK(r.walk.code() == 1);
}

TEST_CASE_TEMPLATE("door: after a fault it starts anew", Architecture, hot, split, ways) {
  heated<Architecture> r;
  r.set("guard.grows", 0.5);  // it is hot after some beats: what is in the motor stays
  r.walk.wait_for_error("holds after the fault");
  CHECK(r.user.call("/cca/resume") == "it faults in its first beat: `guard`: the motor is too hot");
  r.set("guard.grows", 0);
  CHECK(r.user.call("/cca/start") == "");
  CHECK_FALSE(r.status("running").is_null());
  CHECK(r.user.call("/cca/stop") == "");
  CHECK(r.walk.code() == 1);
  CHECK(r.count("started") == 2);  // the resume that faulted was no start
}

TEST_CASE("door: it starts anew with the counts of a new start") {
  heated<> r;
  r.overheat();
  r.cool();
  CHECK(r.user.call("/cca/start") == "");
  CHECK(r.user.call("/cca/stop") == "");
  CHECK(r.walk.code() == 1);
  CHECK(r.count("started") == 2);
  CHECK(r.count("on\n") == 2);
  CHECK(r.count("off\n") == 2);  // before the second start, and at the end
}

TEST_CASE("door: what makes no sense while a fault is held is refused with what does") {
  heated<> r;
  CHECK(r.user.call("/cca/start") == "start: it runs already: after a pause, `start` begins anew");
  r.overheat();
  CHECK(r.user.call("/cca/go_on").find("`resume` goes on") != std::string::npos);
  CHECK(r.user.call("/cca/step").find("`resume` goes on") != std::string::npos);
  CHECK(r.status("faulted")["state"] == "faulted");
  client other(where_in(r.walk.out).port, where_in(r.walk.out).token);
  for (const char* const one : {"/cca/resume", "/cca/start"})
    CHECK(other.call(one).find("must give it back first") != std::string::npos);
  client reader(where_in(r.walk.out).port);
  for (const char* const one : {"/cca/resume", "/cca/start"})
    CHECK(reader.call(one).find("this needs the token") != std::string::npos);
  CHECK(r.status("faulted")["state"] == "faulted");
  CHECK(r.user.call("/cca/stop") == "");
  CHECK(r.walk.code() == 1);
}

TEST_CASE("door: it faults again later, as often as it does") {
  heated<> r;
  for (int i = 0; i < 3; ++i) {
    r.walk.err.clear();
    r.overheat();
    r.cool();
    CHECK(r.user.call("/cca/resume") == "");
    CHECK_FALSE(r.status("running").is_null());
  }
  CHECK(r.user.call("/cca/stop") == "");
  CHECK(r.walk.code() == 1);
  CHECK(r.count("started") == 1);
}

TEST_CASE("door: a fault in a pause is held, and the pause holds after it") {
  heated<> r;
  CHECK(r.user.call("/cca/pause") == "");
  r.set("guard.more", 70);
  CHECK(r.user.call("/cca/step") == "");
  r.walk.wait_for_error("holds after the fault");
  CHECK(r.user.call("/cca/pause") == "");  // it is one already
  r.cool();
  const auto beat = r.status("faulted")["beat"].get<std::int64_t>();
  CHECK(r.user.call("/cca/resume") == "");
  const json paused = r.status([](const json& now) { return now["is_paused"] == true; });
  CHECK(paused["beat"] == beat + 1);
  CHECK(r.user.call("/cca/go_on") == "");
  CHECK_FALSE(
      r.status([&](const json& now) { return now["beat"].get<std::int64_t>() > beat + 5; }).is_null());
  CHECK(r.user.call("/cca/stop") == "");
  CHECK(r.walk.code() == 1);
}

TEST_CASE("door: the speed is the same after a fault") {
  heated<> r;
  CHECK(r.user.call("/cca/speed", {{"factor", 0.05}}) == "");
  r.overheat();
  r.cool();
  CHECK(r.user.call("/cca/resume") == "");
  const auto from = r.status("running")["beat"].get<std::int64_t>();
  json then;
  for (const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(500);
       std::chrono::steady_clock::now() < end;)
    then = r.status("running");  // none waits unread: it would tell of an earlier beat
  CHECK(then["speed"] == 0.05);
  CHECK(then["beat"].get<std::int64_t>() - from < 200);  // 25 and what the test takes; at full speed 500
  CHECK(r.user.call("/cca/stop") == "");
  CHECK(r.walk.code() == 1);
}

TEST_CASE_TEMPLATE("door: in a pause it starts anew, and goes on", Architecture, hot, split, ways) {
  heated<Architecture> r;
  CHECK(r.user.call("/cca/pause") == "");
  CHECK(r.user.call("/cca/start") == "");
  const json runs =
      r.status([](const json& now) { return now["state"] == "running" && now["is_paused"] == false; });
  CHECK_FALSE(runs.is_null());
  CHECK(r.user.call("/cca/stop") == "");
  CHECK(r.walk.code() == 0);
  CHECK(r.count("started") == 2);
  CHECK(r.count("off\n") == 2);
}

TEST_CASE("door: before its first beat it is loaded, and `start` makes it") {
  heated<> r(holding({"--paused"}), false);
  CHECK_FALSE(r.status("loaded").is_null());
  CHECK(r.user.call("/cca/resume") == "resume: nothing has faulted: `start` makes the first beat");
  CHECK(r.count("started") == 0);
  r.set("guard.more", 70);
  CHECK(r.user.call("/cca/start") == "it faults in its first beat: `guard`: the motor is too hot");
  r.cool();
  CHECK(r.user.call("/cca/resume") == "");
  const json runs = r.status("running");
  CHECK(runs["is_paused"] == false);
  CHECK(r.user.call("/cca/stop") == "");
  CHECK(r.walk.code() == 1);
}

TEST_CASE("door: a run as it is told at start ends at a fault, also one that was started by a client") {
  SUBCASE("a run") {
    heated<> r({"--door", "0"});
    r.user.set("guard.more", 70, "set");  // it may end before the answer is sent
    CHECK(r.walk.code() == 1);
    CHECK(r.walk.err.find("holds") == std::string::npos);
  }
  SUBCASE("a first beat") {
    heated<> r({"--door", "0", "--paused"}, false);
    r.set("guard.more", 70);
    r.user.send_call("/cca/start");
    CHECK(r.walk.code() == 1);
  }
  SUBCASE("one that was started anew") {
    heated<> r({"--door", "0"});
    CHECK(r.user.call("/cca/pause") == "");
    CHECK(r.user.call("/cca/start") == "");
    r.user.set("guard.more", 70, "set");
    CHECK(r.walk.code() == 1);
  }
}

TEST_CASE("door: a program that holds a fault ends when it is told") {
  heated<> r;
  r.overheat();
  SUBCASE("by the stop of a client that does not command") {
    client other(where_in(r.walk.out).port, where_in(r.walk.out).token);
    CHECK(other.call("/cca/stop") == "");
  }
  SUBCASE("by SIGINT") { r.walk.send(SIGINT); }
  SUBCASE("by SIGTERM") { r.walk.send(SIGTERM); }
  CHECK(r.walk.code() == 1);  // the fault counts
  CHECK(r.count("off\n") == 1);
}

TEST_CASE("door: a commander that is lost while a fault is held") {
  const auto lose = [](const char* what, auto then) {
    heated<> r(holding({"--on-lost", what}));
    CHECK(r.user.call("/cca/command/push") == "");
    r.overheat();
    r.walk.wait_for("released");  // at the fault, not later
    client next(where_in(r.walk.out).port, where_in(r.walk.out).token);
    r.user.wire.reset();
    then(r, next);
  };
  lose("stop", [](heated<>& r, client&) { CHECK(r.walk.code() == 1); });
  for (const char* const what : {"go-on", "hold"})
    lose(what, [&](heated<>& r, client& next) {
      CHECK(door_test::soon([&] { return next.call("/cca/take_command").empty(); }));
      next.subscribe(9, next.channel("/cca/status"));
      CHECK_FALSE(status_of(next, [](const json& now) { return now["state"] == "faulted"; }).is_null());
      next.set("guard.more", 0, "set");
      CHECK(next.next("parameterValues")["parameters"][0]["value"] == 0);
      CHECK(next.call("/cca/resume") == "");
      const bool holds = std::string(what) == "hold";
      CHECK_FALSE(status_of(next, [&](const json& now) {
                    return now["state"] == "running" && now["is_paused"] == holds;
                  }).is_null());
      CHECK(next.call("/cca/stop") == "");
      CHECK(r.walk.code() == 1);
    });
}

TEST_CASE("door: its time goes on where it was, and is over") {
  heated<> r(holding({"--seconds", "3"}));
  r.overheat();
  const auto beat = r.status("faulted")["beat"].get<std::int64_t>();
  CHECK(beat < 3000);
  r.cool();
  CHECK(r.user.call("/cca/resume") == "");
  CHECK(r.walk.code() == 1);  // by itself
}

TEST_CASE("door: a start that its program never made is no start") {
  using anew = cca::detail::begun_anew;
  anew all;
  all.is_at(anew::place::waiting);
  CHECK(all.ask(anew::wish::start, false).empty());
  CHECK(all.how_it_went(0, false).is == anew::answer::kind::nothing);
  all.ends();
  const auto went = all.how_it_went(0, false);
  CHECK(went.is == anew::answer::kind::refused);
  CHECK(went.why == "the run has ended");
}

TEST_CASE("door: options of a fault are refused in words") {
  child wrong(cca::robot_main<program<hot>>, {"--on-fault", "panic"});
  CHECK(wrong.code() == 2);
  CHECK(wrong.err.find("expected end or hold") != std::string::npos);
  child several(cca::robot_main<program<split>>,
                {"--on-fault", "hold", "--only", "all", "--shared-memory", "/cca_held_fault"});
  CHECK(several.code() == 2);
  CHECK(several.err.find("a fault of several processes ends them all") != std::string::npos);
}

namespace {

// [held]
[[maybe_unused]] cca::state until_told(cca::controller<hot>& c) {
  cca::door door(c, {.port = 8765});
  return door.run(c, cca::for_<600>{}, cca::at_wall_clock());
}
// [held end]

}  // namespace

TEST_CASE("door: a loop of one's own holds a fault, too") {
  cca::controller<hot> c;
  c.load();
  c.start();
  cca::door door(c, {.port = 0, .tells_where = false});
  std::thread window([&] {
    client user(door.port(), door.token());
    CHECK(user.call("/cca/take_command") == "");
    user.subscribe(9, user.channel("/cca/status"));
    const auto becomes = [&](const char* state) {
      return user.waits([&] {
        for (const auto& one : user.samples)
          if (json::parse(one.data)["state"] == state) return true;
        user.samples.clear();
        return false;
      });
    };
    user.set("guard.more", 70);
    CHECK(becomes("faulted"));
    CHECK(user.call("/cca/resume").find("it faults in its first beat") == 0);
    user.set("guard.more", 0, "set");
    CHECK(user.next("parameterValues")["parameters"][0]["value"] == 0);
    CHECK(user.call("/cca/resume") == "");
    CHECK(user.call("/cca/stop") == "");
  });
  CHECK(door.run(c, cca::for_<60>{}, cca::at_wall_clock()) == cca::state::started);
  window.join();
  CHECK(c.beat_index() < 60'000);
}

TEST_CASE("door: a loop that only runs does not hold a fault, and says so") {
  cca::controller<hot> c;
  c.load();
  c.start();
  cca::door door(c, {.port = 0, .tells_where = false});
  std::thread window([&] {
    client user(door.port(), door.token());
    CHECK(user.call("/cca/take_command") == "");
    for (const char* const one : {"/cca/resume", "/cca/start"})
      CHECK(user.call(one).find("--on-fault hold") != std::string::npos);
    CHECK(user.call("/cca/stop") == "");
  });
  c.run(cca::for_<60>{}, cca::at_wall_clock(), door);
  window.join();
}

TEST_CASE("door: one that gives no beat can't hold, and is not opened so") {
  child mind(cca::robot_main<program<two_processes>>,
             {"--door", "0", "--on-lost", "hold", "--only", "mind", "--shared-memory",
              "/cca_no_hold_" + std::to_string(::getpid())});
  CHECK(mind.code() == 2);
  CHECK(mind.err.find("hold is a pause, and another process runs the environment that gives the beat") !=
        std::string::npos);
}

TEST_CASE("door: a fault in one process ends all, and the door of each says which before it closes") {
  const std::string memory = "/cca_two_doors_" + std::to_string(::getpid());
  const auto process = [&](const char* which) {
    return words{"--door", "0", "--only", which, "--shared-memory", memory};
  };
  child body(cca::robot_main<program<two_processes>>, process("body"));
  child mind(cca::robot_main<program<two_processes>>, process("mind"));
  body.wait_for("started");
  mind.wait_for("started");
  const auto of_body = where_in(body.out + body.err), of_mind = where_in(mind.out + mind.err);
  client at_body(of_body.port, of_body.token), at_mind(of_mind.port, of_mind.token);
  for (client* one : {&at_body, &at_mind}) one->subscribe(9, one->channel("/cca/status"));
  const auto runs = [](const json& now) { return now["state"] == "running" && now["beat"] > 100; };
  CHECK_FALSE(status_of(at_body, runs).is_null());
  CHECK(at_mind.call("/cca/take_command") == "");
  const std::string elsewhere =
      ": another process runs the environment that gives the beat: ask the door of that one";
  CHECK(at_mind.call("/cca/pause") == "pause" + elsewhere);
  CHECK(at_mind.call("/cca/go_on") == "go_on" + elsewhere);
  CHECK(at_mind.call("/cca/step") == "step" + elsewhere);
  CHECK(at_mind.call("/cca/speed", {{"factor", 0.5}}) == "speed" + elsewhere);
  at_mind.set("guard.more", 90, "set");
  for (client* one : {&at_body, &at_mind}) {
    json last;
    one->waits([&] {
      for (const auto& s : one->samples)
        if (s.subscription == 9) last = json::parse(s.data);
      one->samples.clear();
      return one->wire.is_closed;
    });
    CHECK(one->wire.is_closed);
    CAPTURE(last.dump());
    CHECK(last["state"] == "faulted");
    CHECK(last["fault"] == "the motor is too hot");
    CHECK(last["fault_path"] == "guard");
  }
  for (child* one : {&body, &mind}) {
    CHECK(one->code() == 1);
    CHECK(one->err.find("fault in `guard`") != std::string::npos);
  }
  CHECK(body.out.find("braked") != std::string::npos);
}
