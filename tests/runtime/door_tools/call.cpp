// cca-call as a script runs it, on a real door.
#include <doctest/doctest.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include "played_program.hpp"
#include "ran.hpp"

namespace {

using namespace door_tools_test;
using about = cca::detail::door_request::what;
using how = cca::detail::door_outcome::how;

ran call(const std::string& port, words arguments, const std::string& token = door_test::token) {
  arguments.insert(arguments.begin(), port);
  return running(CCA_CALL, arguments, token.empty() ? words{} : words{"CCA_TOKEN=" + token}).end();
}

// Beats while a call waits for samples.
struct beating {
  explicit beating(played_program& p)
      : of([&p](const std::stop_token& end) {
          while (!end.stop_requested()) p.beat(), std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }) {}
  std::jthread of;
};

}  // namespace

TEST_CASE("get prints values, one a line, or as JSON, without a token") {
  played_program p;
  const ran all = call(p.address(), {"get"}, "");
  CHECK_EQ(all.code, 0);
  CHECK_EQ(all.out,
           "gait.frequency 1.5 Hz\ngait.steps 3\ngait.is_on true\ngait.kind trot\ngait.gains 1,2,3\n");
  CHECK_EQ(all.err, "");
  CHECK_EQ(call(p.address(), {"get", "gait.gains", "gait.kind"}, "").out,
           "gait.gains 1,2,3\ngait.kind trot\n");
  CHECK_EQ(call(p.address(), {"get", "gait.frequency", "--json"}, "").out,
           "{\n  \"gait.frequency\": 1.5\n}\n");
  const ran wrong = call(p.address(), {"get", "gait.frequncy"}, "");
  CHECK_EQ(wrong.code, 2);
  CHECK_EQ(wrong.err, "cca-call: there is no parameter gait.frequncy, did you mean `gait.frequency`?\n");
}

TEST_CASE("set changes all at once, or says why not, and gives the right to command back") {
  played_program p;
  CHECK_EQ(call(p.address(), {"set", "gait.frequency", "2", "gait.gains=3,2,1", "gait.kind", "walk"}).code,
           0);
  CHECK_EQ(call(p.address(), {"get"}).out,
           "gait.frequency 2 Hz\ngait.steps 3\ngait.is_on true\ngait.kind walk\ngait.gains 3,2,1\n");

  const ran beyond = call(p.address(), {"set", "gait.steps", "4", "gait.frequency", "9"});
  CHECK_EQ(beyond.code, 2);
  CHECK_EQ(beyond.out, "");
  CHECK_EQ(beyond.err, "cca-call: gait.frequency = 9: expected a number from 0.1 to 5 Hz\n");
  CHECK_EQ(call(p.address(), {"get", "gait.steps"}).out, "gait.steps 3\n");
  CHECK_EQ(call(p.address(), {"set", "gait.steps", "many"}).code, 2);
  CHECK_EQ(call(p.address(), {"set", "gait.steps"}).err, "cca-call: gait.steps: expected a value after it\n");
  for (const words& below : {words{"set", "gait.frequency=-1"}, {"set", "gait.frequency", "-1"}}) {
    const ran refused = call(p.address(), below);
    CHECK_EQ(refused.code, 2);
    CHECK_EQ(refused.err, "cca-call: gait.frequency = -1: expected a number from 0.1 to 5 Hz\n");
  }

  p.controls.fake.answers(how::refused);
  const ran refused = call(p.address(), {"set", "gait.frequency", "1"});
  CHECK_EQ(refused.code, 2);
  CHECK_EQ(refused.err, "cca-call: the fake refuses\n");
  p.controls.fake.answers(how::done);
  CHECK_EQ(call(p.address(), {"undo"}).code, 0);
  CHECK_EQ(call(p.address(), {"get", "gait.frequency"}).out, "gait.frequency 1.5 Hz\n");
  for (const std::string& one : p.controls.fake.noted())
    CHECK_EQ(one.find("lost its connection"), std::string::npos);
}

TEST_CASE("what is a call of a service does what its name says") {
  played_program p;
  const auto& fake = p.controls.fake;
  const auto last = [&] { return fake.asked().back(); };
  CHECK_EQ(call(p.address(), {"pause"}).code, 0);
  CHECK_EQ(last().about, about::pause);
  CHECK_EQ(call(p.address(), {"go-on"}).code, 0);
  CHECK_EQ(last().about, about::go_on);
  CHECK_EQ(call(p.address(), {"step"}).code, 0);
  CHECK_EQ(last().number, 1);
  CHECK_EQ(call(p.address(), {"step", "12"}).code, 0);
  CHECK_EQ(last().number, 12);
  CHECK_EQ(call(p.address(), {"speed", "0.5"}).code, 0);
  CHECK_EQ(last().about, about::speed);
  CHECK_EQ(last().number, 0.5);
  CHECK_EQ(call(p.address(), {"mode", "stand"}).code, 0);
  CHECK_EQ(last().text, "stand");
  CHECK_EQ(call(p.address(), {"stop", "arm"}).code, 0);
  CHECK_EQ(last().about, about::stop_part);
  CHECK_EQ(call(p.address(), {"start", "arm"}).code, 0);
  CHECK_EQ(last().about, about::start_part);
  CHECK_EQ(call(p.address(), {"load", "a.toml", "gait"}).code, 0);
  CHECK_EQ(last().about, about::load);
  CHECK_EQ(last().scope, "gait");
  CHECK_EQ(call(p.address(), {"save", "b.toml"}).code, 0);
  CHECK_EQ(last().text, "b.toml");
  CHECK_EQ(call(p.address(), {"record", "c.mcap"}).code, 0);
  CHECK_EQ(last().about, about::record);
  CHECK_EQ(call(p.address(), {"end-recording"}).code, 0);
  CHECK_EQ(last().about, about::end_recording);
  CHECK_EQ(call(p.address(), {"resume"}).code, 0);
  CHECK_EQ(last().about, about::resume);
  CHECK_EQ(call(p.address(), {"start"}).code, 0);
  CHECK_EQ(last().about, about::start);
  CHECK_EQ(call(p.address(), {"stop"}).code, 0);
  CHECK_EQ(last().about, about::end_run);
  const ran outside = call(p.address(), {"load", "/etc/x.toml"});
  CHECK_EQ(outside.code, 2);
  CHECK_NE(outside.err.find("expected a file below the folder"), std::string::npos);
}

TEST_CASE("while another one commands, a change is refused with its name, and stop is not") {
  played_program p;
  running holder(CCA_CALL, {p.address(), "command", "push", "force=10"}, {"CCA_TOKEN=" + door_test::token});
  REQUIRE(holder.writes("push is held until ctrl-c"));
  CHECK(p.controls.fake.was_asked(about::call, "push"));
  const ran refused = call(p.address(), {"pause"});
  CHECK_EQ(refused.code, 2);
  CHECK_NE(refused.err.find("127.0.0.1:"), std::string::npos);
  CHECK_NE(refused.err.find(" commands: it must give the command back first"), std::string::npos);
  CHECK(!p.controls.fake.was_asked(about::pause));
  CHECK_EQ(call(p.address(), {"stop"}).code, 0);
  CHECK(p.controls.fake.was_asked(about::end_run));
  // Ctrl-c gives it back, so what it held is released, and nobody counts as lost.
  holder.send(SIGINT);
  CHECK_EQ(holder.end().code, 130);
  CHECK(door_test::soon([&] { return p.controls.fake.was_asked(about::release, "push"); }));
  for (const std::string& one : p.controls.fake.noted())
    CHECK_EQ(one.find("lost its connection"), std::string::npos);
}

TEST_CASE("a command is held for a time, or once") {
  played_program p;
  CHECK_EQ(call(p.address(), {"command", "push", "force=-10", "--for", "0.1"}).code, 0);
  const auto asked = p.controls.fake.asked();
  REQUIRE_EQ(asked.size(), 2);
  CHECK_EQ(asked[0].about, about::call);
  CHECK_EQ(asked[0].values[0].second.number, -10);
  CHECK_EQ(asked[1].about, about::release);
  CHECK_EQ(call(p.address(), {"command", "wave"}).code, 0);
  CHECK_EQ(call(p.address(), {"command", "wave", "--for", "1"}).code, 2);
  CHECK_EQ(call(p.address(), {"command", "push", "force=99"}).code, 2);
  CHECK_EQ(call(p.address(), {"command", "wive"}).err,
           "cca-call: there is no command wive, did you mean `wave`?; `describe` lists all\n");
  CHECK_EQ(call(p.address(), {"release", "push"}).code, 0);
}

TEST_CASE("watch prints samples with a head, or as JSON") {
  played_program p;
  const beating now(p);
  const ran text = call(p.address(), {"watch", "gait.angles", "--count", "3"}, "");
  CHECK_EQ(text.code, 0);
  CHECK(text.out.starts_with("# time s, beat, origin ns, hip rad, knee rad\n0."));
  CHECK_EQ(std::count(text.out.begin(), text.out.end(), '\n'), 4);
  const ran lines = call(p.address(), {"watch", "/mind/part_0/status", "--count", "2", "--json"}, "");
  const auto one = nlohmann::json::parse(lines.out.substr(0, lines.out.find('\n')));
  CHECK_EQ(one["beat"].get<double>() * 1e-3, doctest::Approx(one["time"].get<double>()));
  CHECK(one.contains("done"));
  const ran status = call(p.address(), {"watch", "/cca/status", "--count", "1"}, "");
  CHECK_EQ(nlohmann::json::parse(status.out)["mode"], "walk");
  const ran none = call(p.address(), {"watch", "gait.angels"}, "");
  CHECK_EQ(none.code, 2);
  CHECK_NE(none.err.find("did you mean `gait.angles`?"), std::string::npos);
}

TEST_CASE("status and describe") {
  played_program p;
  p.controls.fault = "lost contact";
  const ran now = call(p.address(), {"status"}, "");
  CHECK_NE(now.out.find("\nfault lost contact\n"), std::string::npos);
  CHECK_NE(now.out.find("\nstate running\n"), std::string::npos);
  CHECK_NE(now.out.find("\nenvironments.mind.late 17\n"), std::string::npos);
  CHECK_EQ(nlohmann::json::parse(call(p.address(), {"status", "--json"}, "").out)["environments"][0]["name"],
           "robot");
  CHECK_EQ(now.out.find("twins"), std::string::npos);
  door_test::client twin(p.door.port(), door_test::token);
  twin.text({{"op", "cca.twin"}, {"says", "the same, bit for bit: 9 beats"}});
  CHECK(door_test::soon(
      [&] { return call(p.address(), {"status"}, "").out.find("\ntwins.127.0.0.1:") != std::string::npos; }));
  const ran told = call(p.address(), {"status"}, "");
  const auto begin = told.out.find("\ntwins.127.0.0.1:");
  const auto says = told.out.find(" the same, bit for bit: 9 beats\n", begin);
  CHECK_NE(says, std::string::npos);
  CHECK_EQ(told.out.find('\n', begin + 1), told.out.find('\n', says));  // of one line
  const ran all = call(p.address(), {"describe"}, "");
  for (const char* const line :
       {"program oncilla_trot\n", "mode stand\n", "part arm\n", "node sink\n",
        "output gait.angles: hip rad, knee rad\n", "parameter gait.frequency 1.5 Hz (0.1 to 5 Hz)\n",
        "parameter gait.kind trot (trot, walk)\n",
        "command push force=0 (-50 to 50 N) angle=0 (-3 to 3 rad), held: pushes the body\n"})
    CHECK_MESSAGE(all.out.find(line) != std::string::npos, line, " in ", all.out);
}

TEST_CASE("no token, a wrong token, a token in a file") {
  played_program p;
  const ran none = call(p.address(), {"pause"}, "");
  CHECK_EQ(none.code, 2);
  CHECK_EQ(none.err, "cca-call: a change needs the token: --token, --token-file or CCA_TOKEN\n");
  const ran stop = call(p.address(), {"stop"}, "");
  CHECK_EQ(stop.code, 2);
  const ran wrong = call(p.address(), {"pause"}, "0123456789abcdef0123456789abcdee");
  CHECK_EQ(wrong.code, 2);
  CHECK_NE(wrong.err.find("this is not the token of the door at 127.0.0.1:"), std::string::npos);
  CHECK(p.controls.fake.asked().empty());
  std::ofstream("door_tools_call_token") << door_test::token << '\n';
  CHECK_EQ(call(p.address(), {"pause", "--token-file", "door_tools_call_token"}, "").code, 0);
  ::unlink("door_tools_call_token");
}

TEST_CASE("no server, a server that is killed, one that does not take the request") {
  std::string port;
  {
    // A process of its own, that can be killed.
    int ports[2];
    REQUIRE_EQ(::pipe2(ports, O_CLOEXEC), 0);
    const pid_t id = ::fork();
    if (id == 0) {
      played_program p;
      const std::string text = p.address() + "\n";
      [[maybe_unused]] const ssize_t sent = ::write(ports[1], text.data(), text.size());
      for (;;) p.beat(), std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    for (char c = 0; ::read(ports[0], &c, 1) == 1 && c != '\n';) port += c;
    ::close(ports[0]), ::close(ports[1]);
    running watching(CCA_CALL, {port, "watch", "gait.angles"});
    REQUIRE(watching.writes("\n0."));
    ::kill(id, SIGKILL);
    ::waitpid(id, nullptr, 0);
    const ran lost = watching.end();
    CHECK_EQ(lost.code, 3);
    CHECK_EQ(lost.err, "cca-call: 127.0.0.1:" + port + ": the connection is lost\n");
  }
  const ran nobody = call(port, {"get"});
  CHECK_EQ(nobody.code, 3);
  CHECK_EQ(nobody.err, "cca-call: 127.0.0.1:" + port + ": nobody listens there\n");
  // What is wrong in the command line is refused before it connects.
  for (const words& wrong : {words{"set", "gait.steps"},
                             {"command", "push", "force"},
                             {"speed", "0"},
                             {"test", "servo.reference", "drive.angle", "step", "amplitude=nan"},
                             {"test", "servo.reference", "drive.angle", "step", "amplitude"}})
    CHECK_EQ(call(port, wrong).code, 2);

  played_program p;
  p.controls.fake.answers(how::begun);  // and no beat takes it
  const ran late = call(p.address(), {"pause", "--timeout", "0.3"});
  CHECK_EQ(late.code, 3);
  CHECK_NE(late.err.find("/cca/pause was not answered within 300 ms"), std::string::npos);
}

TEST_CASE("a wrong command line is refused before anything is connected") {
  for (const words& wrong : {words{},
                             {"8765"},
                             {"8765", "got"},
                             {"8765", "pause", "now"},
                             {"8765", "watch"},
                             {"x", "get"},
                             {"8765", "pause", "--json"},
                             {"8765", "get", "--count", "2"},
                             {"8765", "start", "arm", "leg"},
                             {"8765", "get", "--token", "a b"},
                             {"8765", "get", "--no"}}) {
    const ran one = running(CCA_CALL, wrong).end();
    CHECK_EQ(one.code, 2);
    CHECK(one.err.starts_with("cca-call: "));
  }
  CHECK_EQ(running(CCA_CALL, {"8765", "puse"}).end().err,
           "cca-call: there is no command `puse`, did you mean `pause`?\n");
  CHECK_EQ(running(CCA_CALL, {"8765", "step", "-3"}).end().err,
           "cca-call: step -3: expected a whole number from 1 to 1000000\n");
  CHECK_EQ(running(CCA_CALL, {"8765", "speed", "-1"}).end().err,
           "cca-call: speed -1: expected a number from 0.001 to 1000\n");
  CHECK_NE(running(CCA_CALL, {"--help"}).end().out.find("set NAME VALUE ..."), std::string::npos);
}
