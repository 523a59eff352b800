// Files on disk: missing ones, unreadable ones, and saves that fail and leave the old file.
#include <doctest/doctest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <sys/resource.h>

#include "mock.hpp"

using config_test::controller;
namespace fs = std::filesystem;

namespace {

struct folder {
  fs::path path =
      fs::temp_directory_path() / ("cca_config_" + std::to_string(reinterpret_cast<std::uintptr_t>(this)));
  folder() { fs::create_directories(path); }
  ~folder() { fs::remove_all(path); }
  std::string operator/(std::string_view name) const { return (path / name).string(); }
};

std::string contents(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

template <class F>
std::string words_of(F f) {
  try {
    f();
  } catch (const cca::refused& refusal) { return refusal.what(); }
  return {};
}

}  // namespace

TEST_SUITE("config files") {
  TEST_CASE("save, then load") {
    const folder here;
    controller written, read;
    written.cpg.p.frequency = 0.1 + 0.2;
    written.save(here / "trot.toml");
    CHECK_EQ(contents(here / "trot.toml"), written.text());
    CHECK_FALSE(fs::exists(here / "trot.toml.new"));
    read.load(here / "trot.toml");
    CHECK_EQ(read.cpg.p.frequency, 0.1 + 0.2);
  }

  TEST_CASE("a file without end is not read to its end") {
    controller c;
    CHECK_EQ(words_of([&] { c.load("/dev/zero"); }),
             "/dev/zero: has more than 16 MB, the most that is read of such a file");
  }

  TEST_CASE("a message names the file as the caller did") {
    const folder here;
    const std::string file = here / "bad.toml";
    std::ofstream(file) << "[cpg]\ngain = 9\n";
    controller c;
    CHECK_EQ(words_of([&] { c.load(file); }), file + ":2: cpg.gain: 9 is out of range, expected 0.1 to 5");
  }

  TEST_CASE("a missing file") {
    controller c;
    CHECK_EQ(words_of([&] { c.load("/nowhere/trot.toml"); }),
             "/nowhere/trot.toml: cannot be read: No such file or directory");
    CHECK_EQ(words_of([&] { c.load("nowhere.toml"); }),
             "nowhere.toml: cannot be read: No such file or directory (looked in " +
                 fs::current_path().string() + ")");
  }

  TEST_CASE("a folder instead of a file") {
    const folder here;
    controller c;
    CHECK_EQ(words_of([&] { c.load(here.path.string()); }),
             here.path.string() + ": cannot be read: Is a directory");
    CHECK_EQ(words_of([&] { c.save(here.path.string()); }),
             here.path.string() + ": cannot be written: Is a directory");
  }

  TEST_CASE("saving into a missing folder") {
    const controller c;
    CHECK_EQ(words_of([&] { c.save("/nowhere/trot.toml"); }),
             "/nowhere/trot.toml: cannot be written: No such file or directory");
  }

  TEST_CASE("values that loading would refuse are not saved, and the old file stays") {
    const folder here;
    const std::string file = here / "trot.toml";
    controller c;
    c.save(file);
    const std::string before = contents(file);
    c.cpg.p.frequency = std::numeric_limits<double>::quiet_NaN();
    c.pose.p.ground = static_cast<config_test::terrain>(9);
    CHECK_EQ(words_of([&] { c.save(file); }),
             file + ": cpg.frequency: nan is not allowed, expected a finite number\n" + file +
                 ": pose.ground: the value 9 has no name, expected flat, slope or steps");
    CHECK_EQ(contents(file), before);
  }

  TEST_CASE("saving through a link keeps the link") {
    const folder here;
    const controller c;
    std::ofstream(here / "real.toml") << "";
    fs::create_symlink(here / "real.toml", here / "link.toml");
    c.save(here / "link.toml");
    CHECK(fs::is_symlink(here / "link.toml"));
    CHECK_EQ(contents(here / "real.toml"), c.text());
  }

  TEST_CASE("a full disk leaves the old file and no other") {
    const folder here;
    const std::string file = here / "trot.toml";
    controller c;
    c.save(file);
    const std::string before = contents(file);
    c.cpg.p.frequency = 2;
    // No file may grow beyond 100 bytes, which looks like a full disk.
    rlimit usual{};
    getrlimit(RLIMIT_FSIZE, &usual);
    const rlimit tight{100, usual.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &tight);
    const std::string words = words_of([&] { c.save(file); });
    setrlimit(RLIMIT_FSIZE, &usual);
    std::signal(SIGXFSZ, handler);
    CHECK_EQ(words, file + ": cannot be written: File too large");
    CHECK_EQ(contents(file), before);
    CHECK_FALSE(fs::exists(file + ".new"));
  }

}  // TEST_SUITE
