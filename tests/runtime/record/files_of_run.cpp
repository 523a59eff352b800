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

struct still : cca::graph<cca::node<"leg", leg>,
                          cca::node<"limits", cca::limiter<leg_angles>>,
                          cca::wire<"leg.angles", "limits.command", cca::delayed<1>>,
                          cca::wire<"limits.safe", "leg.command", cca::delayed<1>>> {};

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

TEST_CASE("a replay refuses each option that it does not use, and says why") {
  struct replaying : program {
    void options(cca::command_line& line) override {
      program::options(line);
      line.words("FILE", files, 1, "");
    }
    std::vector<std::string> files;
  };
  const temporary_file recording("beside"), other("beside_it");
  REQUIRE(run({"--record", recording.path}).code() == 0);
  const std::string from_recording =
                        "a replay does not use it: it takes all from the recording, and calls no",
                    files = "a replay neither records nor traces",
                    pace = "a replay is always a fast run without a pause";
  const auto refused = [&](std::vector<std::string> words, const std::string& why) {
    const std::string option = words.front();
    for (const bool is_first : {false, true}) {
      std::vector<std::string> all = words;
      const std::vector<std::string> replay{"--replay", recording.path};
      all.insert(is_first ? all.begin() : all.end(), replay.begin(), replay.end());
      child one(cca::robot_main<replaying>, all);
      CAPTURE(option);
      CHECK(one.code() == cca::exit_code::refused);
      INFO(one.err);
      CHECK(one.err.starts_with("walk: " + option + " and --replay: " + why));
      CHECK(one.out == "");
    }
  };
  refused({"--config", "/no/such/file"}, "a replay takes the parameters from the recording\n");
  refused({"--seconds", "0.1"}, "a replay is as long as the recording\n");
  refused({"--pace", "fast"}, pace);
  refused({"--commands"}, pace);
  refused({"--record", other.path}, files);
  refused({"--record-only", "leg"}, files);
  refused({"--page", other.path}, files);
  refused({"--trace", other.path}, files);
  refused({"--list"}, "take one of them\n");
  refused({"--write-parameters", other.path}, "take one of them\n");
  refused({"--csv", other.path}, from_recording);
  refused({"word"}, from_recording);
  CHECK_FALSE(fs::exists(other.path));
  child quiet(cca::robot_main<replaying>, {"--quiet", "--replay", recording.path});
  CHECK(quiet.code() == 0);
  CHECK(quiet.out.ends_with(" samples of 100 beats, bit for bit as recorded\n"));
  child unknown(cca::robot_main<replaying>, {"--replay", recording.path, "--slow"});
  CHECK(unknown.code() == cca::exit_code::refused);
  CHECK(unknown.err == "walk: --slow: no such option; --help lists them\n");
}

TEST_CASE("a replay of a deployment has no other processes") {
  struct two : cca::deployment<still, cca::environment<"robot", cca::nodes<"leg">>,
                               cca::environment<"mind", cca::other_nodes>>,
               cca::recordable {};
  child one(cca::robot_main<two>, {"--replay", "none.mcap", "--only", "mind", "--shared-memory", "/none"});
  CHECK(one.code() == cca::exit_code::refused);
  CHECK(one.err == "walk: --only and --replay: a replay computes all environments in one loop\n");
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
