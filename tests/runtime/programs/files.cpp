// What programs write: nothing before all that they read is accepted, beside the target, one writer each, and
// no file twice.
#include <doctest/doctest.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include <unistd.h>

#include <cca/main/one_file.hpp>
#include <cca/base/system/output_file.hpp>
#include <cca/main/run_program.hpp>

#include "child.hpp"

namespace {

namespace fs = std::filesystem;

struct folder {
  fs::path at = fs::temp_directory_path() / ("cca_files_" + std::to_string(::getpid()));
  folder() { fs::create_directories(at); }
  ~folder() { fs::remove_all(at); }
  std::string operator/(const std::string& name) const { return (at / name).string(); }
};

std::string text_in(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}
void put(const std::string& file, const std::string& text) { std::ofstream(file) << text; }

}  // namespace

TEST_CASE("an output file takes its name when it is complete") {
  const folder here;
  const std::string name = here / "a.mcap";
  put(name, "old");
  {
    cca::output_file file(name);
    file.write("new");
    CHECK(file.written_to() == name + ".part");
    CHECK(text_in(name) == "old");
    file.keep();
    CHECK(text_in(name) == "new");
    CHECK_FALSE(fs::exists(name + ".part"));
  }
  {
    cca::output_file file(name);
    file.write("refused");
    file.discard();
  }
  { cca::output_file empty(name); }
  CHECK(text_in(name) == "new");
  CHECK_FALSE(fs::exists(name + ".part"));
  CHECK_THROWS_AS(cca::output_file(here / "none/a.mcap"), std::system_error);
}

TEST_CASE("what a crash has left is never overwritten") {
  const folder here;
  const std::string name = here / "a.mcap";
  for (const char* run : {"first", "second"}) {
    cca::output_file file(name);
    file.write(run);
  }  // neither kept nor discarded, as after a crash
  CHECK(text_in(name + ".part") == "second");
  CHECK(text_in(name + ".part.1") == "first");
  CHECK(cca::set_aside_part(name) == name + ".part.2");
  CHECK(cca::set_aside_part(name) == "");
  CHECK(text_in(name + ".part.2") == "second");
  CHECK_FALSE(fs::exists(name));
}

TEST_CASE("a file has one writer") {
  const folder here;
  const std::string name = here / "a.mcap";
  cca::output_file first(name);
  first.write("first");
  fs::create_symlink(name, here / "link");
  for (const std::string& same : {name, here / "./a.mcap", here / "link"})
    CHECK_THROWS_WITH_AS(cca::output_file second(same), doctest::Contains("it is being written"),
                         cca::refused);
  CHECK(cca::set_aside_part(name) == "");  // it is no leftover
  first.keep();
  CHECK(text_in(name) == "first");
  cca::output_file next(here / "link");  // and links are followed
  next.write("next");
  next.keep();
  CHECK(text_in(name) == "next");
  CHECK(fs::is_symlink(here / "link"));
}

TEST_CASE("a device is written directly") {
  cca::output_file none("/dev/null");
  cca::output_file again("/dev/null");
  none.write("x");
  none.keep();
  CHECK_FALSE(fs::exists("/dev/null.part"));
  cca::output_file full("/dev/full");
  CHECK_THROWS_AS(full.write("x"), std::system_error);
}

TEST_CASE("two names of one file are found, however they are spelled") {
  const folder here;
  const std::string name = here / "a.toml";
  const auto is_refused = [&](const std::string& other) {
    return !cca::complaint_of_one_file({{"--config", name}, {"--record", other}}).empty();
  };
  for (const bool exists : {false, true}) {
    CAPTURE(exists);
    if (exists) put(name, "x");
    fs::remove(here / "link");
    fs::create_symlink("a.toml", here / "link");
    fs::create_directories(here / "in");
    CHECK(is_refused(name));
    CHECK(is_refused(here / "./in/../a.toml"));
    CHECK(is_refused(here / "link"));
    CHECK(is_refused(name + ".part"));
    CHECK_FALSE(is_refused(here / "b.toml"));
    CHECK_FALSE(is_refused(""));
  }
  fs::create_hard_link(name, here / "hard");
  CHECK(is_refused(here / "hard"));
  fs::create_directory_symlink(here.at, here / "in/again");
  CHECK(is_refused(here / "in/again/a.toml"));
  CHECK(cca::complaint_of_one_file({{"--record", "/dev/null"}, {"--trace", "/dev/null"}}).empty());
  CHECK(cca::complaint_of_one_file({{"--config", name}, {"--config", name}}).empty());
}

TEST_CASE("a command line refuses one file for two options") {
  std::string csv, out;
  std::vector<std::string> configs;
  const auto refusal = [&](std::vector<std::string> words) -> std::string {
    cca::command_line line("walks");
    line.text("--csv FILE", csv, "");
    line.texts("--config FILE", configs, "");
    line.text("--name N", out, "");
    try {
      line.parse(std::move(words));
    } catch (const cca::command_line_error& e) { return e.what(); }
    return "";
  };
  CHECK(refusal({"--csv", "a", "--config", "b", "--config", "./a"}) ==
        "--csv a and --config ./a name one file: give each option its own");
  configs.clear();
  CHECK(refusal({"--csv", "a", "--config", "b", "--config", "b", "--name", "a"}) == "");
}
