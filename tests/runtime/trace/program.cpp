// The option --trace of programs, and what is left of a trace when the process is killed.
#include <csignal>
#include <cstdio>
#include <filesystem>

#include <cca/main.hpp>

#include "../programs/child.hpp"
#include "traced_file.hpp"

using namespace trace_test;
using programs_test::child;

namespace {

struct traced : loop, cca::traceable {};

struct walking : cca::robot_program<traced> {
  walking() {
    purpose = "walks";
    settings.speed.reset();
  }
  bool between(controller_type& c) override {
    if (c.beat_index() == 2000) std::puts("2000 beats"), std::fflush(stdout);
    return true;
  }
};

child run(std::vector<std::string> words) { return child(cca::robot_main<walking>, std::move(words)); }

}  // namespace

TEST_CASE("--trace writes a file and prints a summary") {
  const temporary_file file;
  child one = run({"--seconds", "0.2", "--trace", file.path});
  CHECK(one.code() == 0);
  CHECK(one.out.find("walk ") != std::string::npos);
  CHECK(one.out.find("  pair.first") != std::string::npos);
  CHECK(one.out.find("0 overruns, 0 late") != std::string::npos);
  const auto all = events_of(file.path);
  CHECK(beats_of(all, track_named(all, "walk")).size() == 200);
}

TEST_CASE("--trace and --quiet print nothing") {
  const temporary_file file;
  child one = run({"--seconds", "0.2", "--quiet", "--trace", file.path});
  CHECK(one.code() == 0);
  CHECK(one.out == "");
  CHECK(beats_of(events_of(file.path), 1).size() == 200);
}

TEST_CASE("--trace is offered where the graph is traceable") {
  CHECK(run({"--help"}).code() == 0);
  child help = run({"--help"});
  help.code();
  CHECK(help.out.find("--trace FILE") != std::string::npos);
  child other = child(cca::robot_main<loop>, {"--help"});
  CHECK(other.code() == 0);
  CHECK(other.out.find("--trace") == std::string::npos);
  CHECK(child(cca::robot_main<loop>, {"--trace", "x"}).code() == 2);
}

TEST_CASE("a trace that can't be written is told") {
  child none = run({"--seconds", "0.1", "--trace", "/no/such/folder/trace.json"});
  CHECK(none.code() == 3);
  CHECK(none.err.find("/no/such/folder/trace.json can't be opened") != std::string::npos);
  child full = run({"--seconds", "0.1", "--trace", "/dev/full"});
  CHECK(full.code() == 3);
  CHECK(full.err.find("the trace is incomplete: /dev/full can't be written") != std::string::npos);
  child empty = run({"--trace", ""});
  CHECK(empty.code() == 2);
}

TEST_CASE("a signal ends a trace in order") {
  const temporary_file file;
  child one = run({"--pace", "wall-clock", "--trace", file.path});
  one.wait_for("2000 beats");
  one.send(SIGTERM);
  CHECK(one.code() == 128 + SIGTERM);
  CHECK(beats_of(events_of(file.path), 1).size() >= 2000);
}

TEST_CASE("the trace of a killed process can be read") {
  const temporary_file file;
  child one = run({"--pace", "wall-clock", "--trace", file.path});
  one.wait_for("2000 beats");
  one.send(SIGKILL);
  CHECK(one.code() == 128 + SIGKILL);
  CHECK_FALSE(std::filesystem::exists(file.path));
  const std::string text = text_of(file.path + ".part");
  std::filesystem::remove(file.path + ".part");
  REQUIRE(!text.empty());
  CHECK_THROWS(events_in(text));  // it has no last bracket
  const auto beats = beats_of(events_in(text + "]"), 1);
  CHECK(beats.size() > 1000);
  CHECK(beats.back().number + 1 == static_cast<std::int64_t>(beats.size()));
}
