// Options, their help, what is refused, and the exit codes of programs.
#include <doctest/doctest.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <cca/main/run_program.hpp>

#include "child.hpp"

using programs_test::child;

namespace {

enum class paw { left, right };

struct options {
  double speed = 0.5;
  std::optional<double> most;
  std::optional<std::string> csv;
  std::vector<std::string> configs, files;
  int count = 3, node = 5;
  paw with = paw::left;
  std::string ground = "flat";
  bool quiet = false;

  void offer(cca::command_line& line) {
    line.number("--speed V", speed, 0, 1, "m/s (0.5)");
    line.number("--most M", most, -5, 5, "metres");
    line.text("--csv FILE", csv, "every fifth beat");
    line.texts("--config FILE", configs, "parameters");
    line.whole_number("--count N", count, 1, "how many (3)");
    line.whole_number("--node N", node, 1, 127, "of its drive (5)");
    line.one_of("--paw P", with, std::array{"left", "right"}, "left or right (left):\non which side it is");
    line.value(
        "--terrain T",
        [this](const std::string& text) {
          if (text == "sea") throw std::invalid_argument("it can't swim");
          ground = text;
        },
        "the ground");
    line.flag("--quiet", quiet, "prints nothing");
    line.words("FILE PAGE", files, 2, "are written");
  }
};

options parse(const std::vector<std::string>& words) {
  cca::command_line line("walks");
  options o;
  o.offer(line);
  line.parse(words);
  return o;
}

std::string refusal(const std::vector<std::string>& words) {
  try {
    parse(words);
  } catch (const cca::command_line_error& e) { return e.what(); }
  return "it is accepted";
}

template <class Act>
auto program(Act act) {
  return [act](int count, char** words) {
    cca::command_line line("walks");
    options o;
    o.offer(line);
    return cca::run_program(count, words, line, act);
  };
}

}  // namespace

TEST_SUITE("command line") {
  TEST_CASE("options of all kinds") {
    const options o = parse({"--speed",  "0.25",   "a.json",          "--most",  "-2.5",    "--csv",  "x.csv",
                             "--config", "a.toml", "--config=b.toml", "--count", "7",       "--node", "9",
                             "--paw",    "right",  "--terrain",       "steps",   "--quiet", "b.md"});
    CHECK_EQ(o.speed, 0.25);
    CHECK_EQ(o.most, -2.5);
    CHECK_EQ(o.csv, "x.csv");
    CHECK_EQ(o.configs, std::vector<std::string>{"a.toml", "b.toml"});
    CHECK_EQ(o.files, std::vector<std::string>{"a.json", "b.md"});
    CHECK_EQ(o.count, 7);
    CHECK_EQ(o.node, 9);
    CHECK(o.with == paw::right);
    CHECK_EQ(o.ground, "steps");
    CHECK(o.quiet);
    const options none = parse({});
    CHECK_EQ(none.speed, 0.5);
    CHECK(!none.most);
    CHECK(!none.quiet);
  }

  TEST_CASE("a mistake is refused with what was expected") {
    CHECK_EQ(refusal({"--fast"}), "--fast: no such option; --help lists them");
    CHECK_EQ(refusal({"--speed"}), "--speed: expected a value after it");
    CHECK_EQ(refusal({"--speed", "x"}), "--speed x: expected a number from 0 to 1");
    CHECK_EQ(refusal({"--speed", "0.5m"}), "--speed 0.5m: expected a number from 0 to 1");
    CHECK_EQ(refusal({"--speed", "nan"}), "--speed nan: expected a number from 0 to 1");
    CHECK_EQ(refusal({"--speed", "2"}), "--speed 2: expected a number from 0 to 1");
    CHECK_EQ(refusal({"--speed", "1", "--speed", "1"}), "--speed: it stands there twice");
    CHECK_EQ(refusal({"--count", "0"}), "--count 0: expected a whole number, 1 or more");
    CHECK_EQ(refusal({"--count", "1.5"}), "--count 1.5: expected a whole number, 1 or more");
    for (const char* wrong : {"0", "128"})
      CHECK_EQ(refusal({"--node", wrong}),
               std::string("--node ") + wrong + ": expected a whole number from 1 to 127");
    CHECK_EQ(refusal({"--paw", "hind"}), "--paw hind: expected one of left right");
    CHECK_EQ(refusal({"--terrain", "sea"}), "it can't swim");
    CHECK_EQ(refusal({"a", "b", "c"}), "c: expected at most 2 words; see --help");
  }

  TEST_CASE("a number below 0 is a word, where words are expected, and never an option") {
    CHECK_EQ(parse({"-3", "--quiet", "-.5"}).files, std::vector<std::string>{"-3", "-.5"});
    CHECK_EQ(parse({"-30deg", "x=-1"}).files, std::vector<std::string>{"-30deg", "x=-1"});
    CHECK_EQ(refusal({"a", "b", "-3"}), "-3: expected at most 2 words; see --help");
    for (const char* wrong : {"-", "-.", "-x", "-x3", "--3"})
      CHECK_EQ(refusal({wrong}), wrong + std::string(": no such option; --help lists them"));
    cca::command_line no_words("walks");
    CHECK_THROWS_WITH_AS(no_words.parse({"-3"}), "-3: no such option; --help lists them",
                         cca::command_line_error);
  }

  TEST_CASE("the earlier order of a whole number's greatest value and its help is still read") {
    cca::command_line line("walks");
    int node = 5;
    line.whole_number("--node N", node, 1, "of its drive (5)", 127);
    line.parse({"--node", "127"});
    CHECK_EQ(node, 127);
    CHECK(line.help("walk").find("  --node N          of its drive (5)\n") != std::string::npos);
    CHECK_THROWS_WITH_AS(line.parse({"--node", "128"}), "--node 128: expected a whole number from 1 to 127",
                         cca::command_line_error);
  }

  TEST_CASE("help and version") {
    for (const char* word : {"--help", "-h"}) {
      child one(program([] { return 7; }), {"--speed", "0.1", word});
      CHECK_EQ(one.code(), 0);
      CHECK_EQ(one.out,
               "walk: walks\n\n"
               "  --speed V         m/s (0.5)\n"
               "  --most M          metres\n"
               "  --csv FILE        every fifth beat\n"
               "  --config FILE     parameters\n"
               "  --count N         how many (3)\n"
               "  --node N          of its drive (5)\n"
               "  --paw P           left or right (left):\n"
               "                    on which side it is\n"
               "  --terrain T       the ground\n"
               "  --quiet           prints nothing\n"
               "  FILE PAGE         are written\n"
               "  --version         the version of cca\n"
               "  --help            this text\n");
    }
    child version(program([] { return 7; }), {"--version"});
    CHECK_EQ(version.code(), 0);
    CHECK(version.out.starts_with("walk (cca "));
  }

  TEST_CASE("exit codes") {
    CHECK_EQ(child(program([] { return 7; }), {}).code(), 7);
    child wrong(program([] { return 7; }), {"--fast"});
    CHECK_EQ(wrong.code(), cca::exit_code::refused);
    CHECK_EQ(wrong.err, "walk: --fast: no such option; --help lists them\n");
    child refused(program([]() -> int { throw cca::refused("a.toml:3: no such node"); }), {});
    CHECK_EQ(refused.code(), cca::exit_code::refused);
    CHECK_EQ(refused.err, "walk: a.toml:3: no such node\n");
    child error(program([]() -> int { throw std::runtime_error("the disk is full"); }), {});
    CHECK_EQ(error.code(), cca::exit_code::error);
    CHECK_EQ(error.err, "walk: the disk is full\n");
  }
}
