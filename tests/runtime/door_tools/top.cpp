// cca-top in a terminal, on a real door.
#include <doctest/doctest.h>

#include <signal.h>

#include <memory>
#include <string>
#include <thread>

#include "played_program.hpp"
#include "ran.hpp"

namespace {

using namespace door_tools_test;
using about = cca::detail::door_request::what;

const std::string leave = "\x1b[?25h\x1b[?1049l";

words in_environment(const std::string& token = door_test::token, const char* locale = "C.UTF-8") {
  words all{"TERM=xterm", std::string("LC_ALL=") + locale};
  if (!token.empty()) all.push_back("CCA_TOKEN=" + token);
  return all;
}

struct beating {
  explicit beating(played_program& p)
      : of([&p](const std::stop_token& end) {
          while (!end.stop_requested()) p.beat(), std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }) {}
  std::jthread of;
};

}  // namespace

TEST_CASE("it shows the program, changes a parameter, stops the run, and leaves the terminal as it was") {
  played_program p(300);
  const beating now(p);
  in_terminal t(CCA_TOP, {p.address()}, in_environment());
  CHECK(t.shows("oncilla_trot"));
  CHECK(t.shows("nobody commands"));
  CHECK(t.shows("1000 Hz"));
  t.type("c");
  CHECK(t.shows("YOU COMMAND"));
  t.type("2");
  CHECK(t.shows("0.1 to 5 Hz"));
  t.type(
      "\r\x15"
      "9\r");
  CHECK(t.shows("gait.frequency = 9: expected a number from 0.1 to 5 Hz"));
  t.type(
      "\r\x15"
      "2.5\r");
  CHECK(t.shows("gait.frequency is 2.5 Hz"));
  t.type("p");
  CHECK(door_test::soon([&] { return p.controls.fake.was_asked(about::pause); }));
  CHECK(t.shows("paused, running"));
  t.type("c");
  CHECK(t.shows("nobody commands"));
  t.type(" ");
  CHECK(t.shows("STOP: the run ends"));
  CHECK(p.controls.fake.was_asked(about::end_run));
  t.resize(60, 12);
  CHECK(t.shows("\x1b[2J"));
  CHECK(t.shows(" SPACE STOP "));
  t.type("q");
  CHECK(t.shows(leave));
  CHECK_EQ(t.end(), 0);
  CHECK(t.is_as_before());
}

TEST_CASE("it holds a command of the program, and what it held ends with it") {
  played_program p;
  const beating now(p);
  in_terminal t(CCA_TOP, {p.address()}, in_environment());
  CHECK(t.shows("nobody commands"));
  t.type("c");
  CHECK(t.shows("YOU COMMAND"));
  t.type("5\r");
  CHECK(t.shows("force=0,angle=0"));
  t.type(
      "\x15"
      "force=20\r");
  CHECK(t.shows("HELD"));
  CHECK(p.controls.fake.was_asked(about::call));
  t.type("q");
  CHECK_EQ(t.end(), 0);
  CHECK(door_test::soon([&] { return p.controls.fake.was_asked(about::release); }));
}

TEST_CASE("without a token it only reads, with a wrong one it says so") {
  played_program p;
  {
    in_terminal t(CCA_TOP, {p.address()}, in_environment(""));
    CHECK(t.shows("you only read"));
    CHECK(t.shows("SPACE STOP needs a token"));
    t.type(" p");
    CHECK(t.shows("you only read: cca-top --token"));
  }
  in_terminal t(CCA_TOP, {p.address(), "--token", "0123456789abcdef0123456789abcdee"}, in_environment(""));
  CHECK(t.shows("this is not the token of this door: you only read"));
  t.type(" ");
  CHECK(t.shows("this needs the token"));  // the door's own word
  CHECK(p.controls.fake.asked().empty());
}

TEST_CASE("it waits for a program, and connects again to one that starts anew") {
  auto p = std::make_unique<played_program>();
  const std::string port = p->address();
  {
    in_terminal t(CCA_TOP, {port}, in_environment());
    CHECK(t.shows("nobody commands"));
    p.reset();
    CHECK(t.shows("NOT CONNECTED"));
    t.type(" ");
    CHECK(t.shows("NOT CONNECTED: STOP WAS NOT SENT"));
    door_test::fake_controls again;
    cca::door_settings there = door_test::quiet();
    there.port = static_cast<std::uint16_t>(std::stoi(port));
    const cca::detail::door_server door(there, again);
    CHECK(t.shows("fake"));  // the name of the program
    t.type(" ");
    CHECK(t.shows("STOP: the run ends"));
    CHECK(again.was_asked(about::end_run));
    t.type("q");
    CHECK_EQ(t.end(), 0);
  }
  in_terminal t(CCA_TOP, {port}, in_environment());
  CHECK(t.shows("nobody listens there; trying again"));
  t.type("\x03");
  CHECK(t.shows(leave));
  CHECK_EQ(t.end(), 0);
}

TEST_CASE("however it ends, the terminal is as it was") {
  played_program p;
  for (const int number : {SIGTERM, SIGHUP, SIGINT, SIGABRT, SIGSEGV, SIGQUIT}) {
    in_terminal t(CCA_TOP, {p.address()}, in_environment());
    CHECK(t.shows("nobody commands"));
    t.send(number);
    CHECK(t.shows(leave));
    CHECK_EQ(t.end(), 128 + number);
    CHECK(t.is_as_before());
  }
}

TEST_CASE("a program that commands and goes away gives the command back") {
  played_program p;
  in_terminal t(CCA_TOP, {p.address()}, in_environment());
  CHECK(t.shows("nobody commands"));
  t.type("c");
  CHECK(t.shows("YOU COMMAND"));
  t.type("q");
  CHECK_EQ(t.end(), 0);
  CHECK(door_test::soon([&] { return p.controls.fake.noted().back().ends_with("gives the command back"); }));
  // Where its terminal is gone its user is, too: what the program was told for a lost commander happens.
  in_terminal gone(CCA_TOP, {p.address()}, in_environment());
  CHECK(gone.shows("nobody commands"));
  gone.type("c");
  CHECK(gone.shows("YOU COMMAND"));
  gone.send(SIGHUP);
  CHECK_EQ(gone.end(), 129);
  CHECK(door_test::soon(
      [&] { return p.controls.fake.noted().back().ends_with("lost its connection while it commanded"); }));
}

TEST_CASE("where there is no terminal it says so") {
  const ran one = running(CCA_TOP, {"8765"}, {"TERM=xterm"}).end();
  CHECK_EQ(one.code, 2);
  CHECK_EQ(one.err, "cca-top: this needs a terminal; in scripts use cca-call\n");
  CHECK_EQ(running(CCA_TOP, {}).end().code, 2);
  in_terminal dumb(CCA_TOP, {"8765"}, {"TERM=dumb"});
  CHECK(dumb.shows("this terminal has no screen"));
  CHECK_EQ(dumb.end(), 2);
}
