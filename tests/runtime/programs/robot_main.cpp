// The main function for robots: each option, each refusal, signals, faults and exit codes; two processes.
#include <doctest/doctest.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <cca/main.hpp>

#include "../../laws/temporary_file.hpp"
#include "../deployment/robot_and_mind.hpp"
#include "child.hpp"

using namespace deployment_test;
using programs_test::child;

namespace {

std::string fresh_name() {
  static int number = 0;
  return "/cca_main_" + std::to_string(::getpid()) + "_" + std::to_string(number++);
}

using file = laws::temporary_file;

// Says what is called, and where it stood at the end.
template <class Architecture>
struct telling : cca::robot_program<Architecture> {
  using controller_type = typename telling::controller_type;
  bool has_told = false;
  std::string mistake;
  double most = 0;

  telling() {
    this->purpose = "walks";
    this->settings.speed.reset();
  }
  void options(cca::command_line& line) override {
    line.text("--mistake M", mistake, "throws there");
    line.number("--most M", most, 0, 1e9, "the guard's");
  }
  void tell(const char* what) {
    std::printf("%s;", what);
    std::fflush(stdout);
    if (mistake == what) throw std::runtime_error("mistake");
  }
  void prepare(controller_type&) override { tell("prepare"); }
  void loaded(controller_type& c) override {
    if (most > 0) c.template set<"guard">({most});
    tell("loaded");
  }
  bool between(controller_type& c) override {
    if (!has_told) has_told = true, tell("between");
    return mistake != "ends at 7" || c.beat_index() < 7;
  }
  void stop(controller_type& c) override {
    tell("stop");
    cca::robot_program<Architecture>::stop(c);
  }
  int finish(controller_type& c) override {
    tell("finish");
    std::printf("%lld beats", static_cast<long long>(c.beat_index()));
    if (this->runs("robot"))
      std::printf(", gain %g, command %a, %d faults", c.template get<"filter">().p.gain,
                  c.template get<"device">().command, c.template get<"device">().faults);
    std::puts("");
    return 42;
  }
};

// A busy machine is no lost contact here.
struct patient : cca::deployment<architecture,
                                 cca::environment<"robot", cca::nodes<"device", "filter", "guard">>,
                                 cca::environment<"mind", cca::other_nodes>,
                                 cca::tolerate<100'000>> {};

// But where contact has to be lost.
struct punctual : cca::deployment<architecture,
                                  cca::environment<"robot", cca::nodes<"device", "filter", "guard">>,
                                  cca::environment<"mind", cca::other_nodes>,
                                  cca::tolerate<500>> {};

using one_loop = telling<architecture>;
using two_loops = telling<patient>;
using two_in_time = telling<punctual>;

template <class Program>
child run(std::vector<std::string> words) {
  return child(cca::robot_main<Program>, std::move(words));
}

constexpr const char* whole = "prepare;loaded;between;stop;finish;";

}  // namespace

TEST_SUITE("robot_main") {
  TEST_CASE_TEMPLATE("runs, stops and gives the program's exit code", Program, one_loop, two_loops) {
    child one = run<Program>({"--seconds", "0.05"});
    CHECK_EQ(one.code(), 42);
    CHECK(one.out.starts_with(std::string(whole) + "50 beats, gain 0.1, "));
    CHECK_EQ(one.err, "");
    child ends = run<Program>({"--mistake", "ends at 7"});  // without --seconds it would run for ever
    CHECK_EQ(ends.code(), 42);
    CHECK(ends.out.starts_with(std::string(whole) + "7 beats"));
    CHECK_EQ(ends.err, "");
  }

  TEST_CASE("a graph or a deployment alone is a program") {
    CHECK_EQ(child(cca::robot_main<architecture>, {"--seconds", "0.01", "--pace", "fast"}).code(), 0);
    child help(cca::robot_main<two>, {"--help"});
    CHECK_EQ(help.code(), 0);
    CHECK(help.out.find("--only E,F") != std::string::npos);
    CHECK(help.out.starts_with("walk: runs "));
    CHECK(help.out.find("until a signal") != std::string::npos);
    CHECK(help.out.find("(wall-clock)") != std::string::npos);
  }

  TEST_CASE_TEMPLATE("parameters from files, the last one counts", Program, one_loop, two_loops) {
    const file first("first.toml", "[filter]\ngain = 0.2\n[guard]\nmost = 100.0\n"),
        second("second.toml", "[filter]\ngain = 0.3\n");
    child one = run<Program>({"--seconds", "0.01", "--config", first.path, "--config", second.path});
    CHECK_EQ(one.code(), 42);
    CHECK(one.out.find("gain 0.3") != std::string::npos);
    const file wrong("wrong.toml", "[filtr]\ngain = 0.2\n");
    child bad = run<Program>({"--config", wrong.path});
    CHECK_EQ(bad.code(), 2);
    CHECK_EQ(bad.out, "prepare;");
    CHECK(bad.err.find(":1: filtr: unknown node, did you mean `filter`?") != std::string::npos);
    CHECK_EQ(run<Program>({"--config", "/no/such/file"}).code(), 2);
  }

  TEST_CASE_TEMPLATE("a table in a wall-clock run, none when quiet or fast", Program, one_loop, two_loops) {
    child one = run<Program>({"--seconds", "0.1", "--pace", "wall-clock"});
    CHECK_EQ(one.code(), 42);
    CHECK(one.out.find("wake-up [us]") != std::string::npos);
    CHECK(one.out.find("100") != std::string::npos);
    child slow = run<Program>({"--seconds", "0.02", "--pace", "0.5"});
    CHECK_EQ(slow.code(), 42);
    CHECK(slow.out.find("wake-up [us]") != std::string::npos);
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"--seconds", "0.02", "--pace", "wall-clock", "--quiet"},
                                               {"--seconds", "0.02", "--pace", "fast"}}) {
      child silent = run<Program>(words);
      CHECK_EQ(silent.code(), 42);
      CHECK(silent.out.find("wake-up") == std::string::npos);
    }
  }

  TEST_CASE_TEMPLATE("a fault is told, stops the robot and gives 1", Program, one_loop, two_loops) {
    child one = run<Program>({"--most", "5"});
    CHECK_EQ(one.code(), 1);
    CHECK(one.out.starts_with(whole));
    CHECK(one.out.find("1 faults") != std::string::npos);
    CHECK(one.err.starts_with("walk: fault in `guard`, after "));
    CHECK(one.err.ends_with(": too much\n"));
  }

  TEST_CASE_TEMPLATE("a signal ends it in order", Program, one_loop, two_loops) {
    for (const int number : {SIGINT, SIGTERM, SIGHUP})
      for (const char* pace : {"fast", "wall-clock"}) {
        child one = run<Program>({"--pace", pace});
        one.wait_for("between;");
        one.send(number);
        CHECK_EQ(one.code(), 128 + number);
        CHECK(one.out.starts_with("prepare;loaded;between;stop;"));
        CHECK(one.out.find("finish;") != one.out.npos);
        CHECK(one.err.starts_with("walk: interrupted after "));
      }
  }

  TEST_CASE_TEMPLATE("an exception stops the robot", Program, one_loop, two_loops) {
    child early = run<Program>({"--mistake", "loaded"});
    CHECK_EQ(early.code(), 3);
    CHECK_EQ(early.out, "prepare;loaded;");
    CHECK_EQ(early.err, "walk: mistake\n");
    child later = run<Program>({"--mistake", "between"});
    CHECK_EQ(later.code(), 3);
    CHECK_EQ(later.out, "prepare;loaded;between;stop;");
  }

  TEST_CASE("wrong use is refused") {
    const auto refusal = [](child one) {
      CHECK_EQ(one.code(), 2);
      CHECK_EQ(one.out, "");
      return one.err;
    };
    CHECK_EQ(refusal(run<one_loop>({"--fast"})), "walk: --fast: no such option; --help lists them\n");
    CHECK_EQ(refusal(run<one_loop>({"--seconds", "abc"})),
             "walk: --seconds abc: expected a number from 0.001 to 1e+09\n");
    CHECK_EQ(
        refusal(run<one_loop>({"--pace", "slow"})),
        "walk: --pace slow: expected fast, wall-clock or a factor from 0.001 to 1000: 0.5 is half as fast "
        "as the clock\n");
    CHECK_EQ(refusal(run<one_loop>({"--only", "robot"})),
             "walk: --only: no such option; --help lists them\n");
    CHECK_EQ(refusal(run<two_loops>({"--only", "robt"})),
             "walk: --only robt: there is no environment `robt`, only robot, mind\n");
    CHECK_EQ(refusal(run<two_loops>({"--only", "robot,"})),
             "walk: --only robot,: there is no environment ``, only robot, mind\n");
    CHECK_EQ(refusal(run<two_loops>({"--only", "robot"})),
             "walk: --only robot: say how it reaches the other environments: --shared-memory NAME\n");
    CHECK_EQ(refusal(run<two_loops>({"--shared-memory", "/x"})),
             "walk: --shared-memory: say by --only which environments this process runs: robot, mind\n");
    CHECK_EQ(refusal(run<two_loops>({"--only", "mind", "--shared-memory", fresh_name(), "--pace", "fast"})),
             "walk: --pace: `robot` gives the beat: say it to the process that runs it\n");
    CHECK(refusal(run<two_loops>({"--only", "mind", "--shared-memory", "a/b"})).find("is no name") !=
          std::string::npos);
  }

  TEST_CASE("two processes over shared memory do what one loop does") {
    const std::string name = fresh_name();
    child mind = run<two_loops>({"--only", "mind", "--shared-memory", name});
    child robot = run<two_loops>({"--only", "robot", "--shared-memory", name, "--seconds", "0.2"});
    child one = run<one_loop>({"--seconds", "0.2"});
    CHECK_EQ(robot.code(), 42);
    CHECK_EQ(one.code(), 42);
    CHECK_EQ(robot.out, one.out);
    CHECK_EQ(mind.code(), 42);
    CHECK(mind.out.ends_with("200 beats\n"));
    CHECK_EQ(mind.err, "walk: another process has ended the run after 0.200 s\n");
    child both = run<two_loops>({"--only", "robot,mind", "--shared-memory", name, "--seconds", "0.2"});
    CHECK_EQ(both.code(), 42);
    CHECK_EQ(both.out, one.out);
  }

  TEST_CASE("a signal to one process ends the other in order") {
    const std::string name = fresh_name();
    child mind = run<two_loops>({"--only", "mind", "--shared-memory", name});
    child robot = run<two_loops>({"--only", "robot", "--shared-memory", name, "--pace", "wall-clock"});
    robot.wait_for("between;");
    mind.wait_for("between;");
    mind.send(SIGTERM);
    CHECK_EQ(mind.code(), 128 + SIGTERM);
    CHECK_EQ(robot.code(), 42);
    CHECK(robot.err.starts_with("walk: another process has ended the run after "));
    CHECK(robot.out.find("wake-up [us]") != std::string::npos);
  }

  TEST_CASE("a process that dies is a fault of the other") {
    const std::string name = fresh_name();
    child mind = run<two_loops>({"--only", "mind", "--shared-memory", name});
    child robot = run<two_loops>({"--only", "robot", "--shared-memory", name});
    robot.wait_for("between;");
    mind.wait_for("between;");
    mind.send(SIGKILL);
    CHECK_EQ(robot.code(), 1);
    CHECK(robot.err.find("lost contact with `mind`") != std::string::npos);
    CHECK(robot.out.find("stop;finish;") != std::string::npos);
  }

  TEST_CASE("a fault is told while a process that stands still holds the run up") {
    const std::string name = fresh_name();
    child mind = run<two_in_time>({"--only", "mind", "--shared-memory", name});
    child robot = run<two_in_time>({"--only", "robot", "--shared-memory", name, "--pace", "wall-clock"});
    robot.wait_for("between;");
    mind.wait_for("between;");
    mind.send(SIGSTOP);
    robot.wait_for_error("lost contact with `mind`");
    robot.wait_for_error("; the run waits until `mind` has ended\n");
    CHECK(robot.err.starts_with("walk: fault, after "));
    ::usleep(2'100'000);  // since the first SIGINT
    robot.send(SIGINT);
    ::usleep(2'100'000);
    robot.send(SIGINT);
    CHECK_EQ(robot.code(), 130);
    CHECK(robot.err.find("Left behind: its robot has been stopping since its fault, but whether it has was "
                         "not said; the other processes lose contact\n") != std::string::npos);
  }

  TEST_CASE("a fault is told while a beat of another environment hangs") {
    struct hanging : two_in_time {
      void started(controller_type& c) override {
        two_in_time::started(c);
        stall_in_ms = 8000;
        beat_that_stalls = 50;
      }
    };
    child one = run<hanging>({"--pace", "wall-clock"});
    one.wait_for_error("; the run waits until `mind` has ended\n");
    CHECK(one.err.starts_with("walk: fault, after "));
    CHECK(one.err.find("lost contact with `mind`: `mind` needed ") != std::string::npos);
  }

  TEST_CASE("a program offers a transport by one line") {
    struct further : cca::shared_memory {  // made of a number
      explicit further(int number) : shared_memory("/cca_further_" + std::to_string(number)) {}
    };
    struct offering : two_loops {
      void options(cca::command_line& line) override {
        two_loops::options(line);
        transport<further>(line, "--further N", "reaches the others by that");
      }
    };
    const std::string number = std::to_string(::getpid());
    child mind = run<offering>({"--only", "mind", "--further", number});
    CHECK_EQ(run<offering>({"--only", "robot", "--further", number, "--seconds", "0.1"}).code(), 42);
    CHECK_EQ(mind.code(), 42);
    child two_of_them = run<offering>({"--only", "mind", "--further", "1", "--shared-memory", "/x"});
    CHECK_EQ(two_of_them.code(), 2);
    CHECK_EQ(two_of_them.err, "walk: --shared-memory and --further: take one of them\n");
    child neither = run<offering>({"--only", "mind"});
    CHECK_EQ(neither.code(), 2);
    CHECK(neither.err.find("--further N or --shared-memory NAME") != std::string::npos);
  }

  TEST_CASE("an option of the program takes the place of a standard one") {
    struct own : one_loop {
      double trot = 0;
      void options(cca::command_line& line) override {
        one_loop::options(line);
        line.number("--seconds S", trot, 1, 20, "of trot");
      }
      int finish(controller_type&) override { return trot == 3 ? 0 : 1; }
    };
    CHECK_EQ(run<own>({"--seconds", "3", "--mistake", "ends at 7"}).code(), 0);
    child help = run<own>({"--help"});
    CHECK_EQ(help.code(), 0);
    CHECK(help.out.find("of trot") != std::string::npos);
    CHECK(help.out.find("until a signal") == std::string::npos);
  }
}
