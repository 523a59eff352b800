// The files of a program's run: no option, refusal, second process or crash destroys an earlier recording.
#include <doctest/doctest.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <cca/main.hpp>
#include <cca/record/replay_option.hpp>

#include "../programs/child.hpp"
#include "graphs.hpp"

using namespace record_test;
using programs_test::child;

namespace {

namespace fs = std::filesystem;

struct graph : walking<>, cca::traceable {};
struct program : cca::robot_program<graph> {
  program() {
    settings.speed.reset();
    settings.seconds = 0.1;
    settings.quiet = true;
  }
  void options(cca::command_line& line) override {
    line.text("--csv FILE", csv, "");
    line.text("--mistake M", mistake, "");
  }
  void loaded(controller_type&) override {
    if (mistake == "loaded") throw cca::refused("mistake");
  }
  void started(controller_type&) override {
    if (mistake == "started") throw cca::refused("mistake");
  }
  bool between(controller_type& c) override {
    if (mistake == "between" && c.beat_index() == 7) throw cca::refused("mistake");
    if (c.beat_index() == 2000) std::puts("2000 beats"), std::fflush(stdout);
    return true;
  }
  std::string csv, mistake;
};
child run(std::vector<std::string> words) { return child(cca::robot_main<program>, std::move(words)); }

std::string bytes_in(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
bool has_part(const std::string& name) { return fs::exists(name + ".part"); }

}  // namespace

TEST_CASE("what is refused leaves the earlier recording as it was") {
  const temporary_file recording("earlier"), wrong("wrong"), link("link"), other("other");
  std::ofstream(wrong.path) << "[filtr]\ngain = 1\n";
  REQUIRE(run({"--record", recording.path}).code() == 0);
  const std::string earlier = bytes_in(recording.path);
  REQUIRE(earlier.starts_with("\x89MCAP"));
  fs::create_symlink(recording.path, link.path);
  const std::string relative = fs::relative(recording.path).string();
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"--config", wrong.path},
                                             {"--config", "/no/such/file"},
                                             {"--record-only", "nothing"},
                                             {"--mistake", "loaded"},
                                             {"--mistake", "started"},
                                             {"--no-such-option"},
                                             {"--config", recording.path},
                                             {"--trace", recording.path},
                                             {"--trace", relative},
                                             {"--trace", link.path},
                                             {"--page", link.path},
                                             {"--csv", recording.path},
                                             {"--csv", recording.path + ".part"}}) {
    CAPTURE(words.front());
    CAPTURE(words.back());
    std::vector<std::string> all{"--record", recording.path};
    all.insert(all.end(), words.begin(), words.end());
    child one = run(all);
    CHECK(one.code() == 2);
    CHECK(one.err != "");
    CHECK(bytes_in(recording.path) == earlier);
    CHECK_FALSE(has_part(recording.path));
  }
  CHECK(bytes_in(wrong.path) == "[filtr]\ngain = 1\n");
}

TEST_CASE("once it has run, a refusal keeps what was recorded") {
  const temporary_file recording("half");
  CHECK(run({"--record", recording.path, "--mistake", "between"}).code() == 2);
  CHECK(cca::recording::replay<graph>(recording.path).beats == 7);
}

TEST_CASE("a replay says where the part of a missing recording is") {
  struct replaying : program {};
  const temporary_file recording("missing");
  std::ofstream(recording.path + ".part") << "x";
  child one(cca::robot_main<replaying>, {"--replay", recording.path});
  CHECK(one.code() == 2);
  CHECK(one.err.find("a run that did not end has left " + recording.path + ".part") != std::string::npos);
  fs::remove(recording.path + ".part");
}

TEST_CASE("a recording has one writer") {
  const temporary_file recording("one_writer");
  child first = run({"--record", recording.path, "--pace", "wall-clock", "--seconds", "1000"});
  first.wait_for("2000 beats");
  child second = run({"--record", recording.path});
  CHECK(second.code() == 2);
  CHECK(second.err.find("it is being written by another program") != std::string::npos);
  first.send(SIGTERM);
  CHECK(first.code() == 128 + SIGTERM);
  CHECK(cca::recording::replay<graph>(recording.path).beats >= 2000);
}

TEST_CASE("a crash leaves a part that can be replayed, and the next run says where it is") {
  const temporary_file recording("crashed");
  REQUIRE(run({"--record", recording.path}).code() == 0);
  const std::string earlier = bytes_in(recording.path);
  child crashed = run({"--record", recording.path, "--pace", "wall-clock", "--seconds", "1000"});
  crashed.wait_for("2000 beats");
  crashed.send(SIGKILL);
  CHECK(crashed.code() == 128 + SIGKILL);
  CHECK(bytes_in(recording.path) == earlier);
  const auto part = cca::recording::replay<graph>(recording.path + ".part");
  INFO(part);
  CHECK(part.beats > 500);
  CHECK(part.difference == "");
  child next = run({"--record", recording.path});
  CHECK(next.code() == 0);
  CHECK(next.err == "walk: a run that did not end has left a part of " + recording.path + ": it is now " +
                        recording.path + ".part.1\n");
  CHECK(bytes_in(recording.path) == earlier);  // the same run again
  CHECK(cca::recording::replay<graph>(recording.path + ".part.1").beats == part.beats);
  fs::remove(recording.path + ".part.1");
}
