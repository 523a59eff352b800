// What is typed while a robot's program runs: pause, go on, one beat, speed.
#include <doctest/doctest.h>

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include <cca/main.hpp>

#include "child.hpp"

using namespace std::chrono_literals;
using programs_test::child;

namespace {

struct reading : cca::space<cca::number, cca::axes<cca::x>> {};
struct device {
  auto sense() -> cca::out<"y", reading> { return 0; }
  void on_idle() { ++idles; }
  int idles = 0;
};
struct architecture : cca::graph<cca::rate<1000>, cca::node<"device", device>> {};
struct split : cca::deployment<architecture, cca::environment<"robot", cca::other_nodes>> {};

template <class Architecture>
struct program : cca::robot_program<Architecture> {
  using controller_type = typename program::controller_type;
  bool between(controller_type& c) override {
    if (c.beat_index() == 20 || c.beat_index() == 2000)
      std::printf("%d;", static_cast<int>(c.beat_index())), std::fflush(stdout);
    return true;
  }
  int finish(controller_type& c) override {
    std::printf("%d beats, %d idle\n", static_cast<int>(c.beat_index()), c.template get<"device">().idles);
    return 0;
  }
};

// Its standard input is a pipe.
struct typed {
  int ends[2] = {-1, -1};
  typed() { REQUIRE_EQ(::pipe(ends), 0); }
  ~typed() {
    for (const int end : ends) ::close(end);
  }
  template <class Program>
  auto main() const {
    return [this](int count, char** words) {
      ::dup2(ends[0], 0);
      return cca::robot_main<Program>(count, words);
    };
  }
  void line(const std::string& text) const {
    const std::string all = text + "\n";
    CHECK_EQ(::write(ends[1], all.data(), all.size()), static_cast<ssize_t>(all.size()));
  }
};

}  // namespace

TEST_SUITE("typed commands") {
  TEST_CASE_TEMPLATE("pause, single beats, go on", Architecture, architecture, split) {
    const typed in;
    child one(in.main<program<Architecture>>(), {"--commands", "--quiet"});
    one.wait_for("20;");
    in.line("p");
    std::this_thread::sleep_for(500ms);
    for (int i = 0; i < 5; ++i) in.line("s"), std::this_thread::sleep_for(100ms);
    in.line("sleep");
    one.wait_for_error("`sleep` is no command: p pauses");
    one.send(SIGINT);
    CHECK_EQ(one.code(), 130);
    int beats = 0, idles = 0;
    const auto at = one.out.find("20;");
    REQUIRE_EQ(std::sscanf(one.out.c_str() + at + 3, "%d beats, %d idle", &beats, &idles), 2);
    CHECK_LT(beats, 700);  // it ran for more than a second
    CHECK_GT(idles, 200);
  }

  TEST_CASE("another speed") {
    const typed in;
    child one(in.main<program<architecture>>(), {"--commands", "--quiet", "--pace", "0.1"});
    one.wait_for("20;");
    in.line("50");
    one.wait_for("2000;");  // without it after 20 s
    in.line("pause");
    std::this_thread::sleep_for(100ms);
    in.line("g");
    one.send(SIGTERM);
    CHECK_EQ(one.code(), 143);
  }

  TEST_CASE("the words") {
    cca::detail::run_control control;
    const auto obey = [&](const char* line) { return cca::detail::run_commands::obey(control, line); };
    for (const char* line :
         {"p", "pause", " g ", "go", "s", "step", "", "x 0.5", "2", "0.001", "1000", "p\r"})
      CHECK(obey(line) == "");
    for (const char* line : {"stop", "0", "-1", "1001", "x", "x fast", "0.5x", "nan", "pp"})
      CHECK(obey(line).find("is no command") != std::string::npos);
    for (const char* line : {"r", "resume", "start"})  // nobody would do it
      CHECK(obey(line).find("--on-fault hold") != std::string::npos);
    control.anew.is_at(cca::detail::begun_anew::place::waiting);
    CHECK(obey("resume").find("`start` makes the first beat") != std::string::npos);
    CHECK(obey("start") == "");
    CHECK(obey("start").find("has not been done yet") != std::string::npos);
  }
}
