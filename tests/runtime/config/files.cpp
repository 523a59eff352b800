// Files on disk: missing ones, unreadable ones, and saves that fail and leave the old file.
#include <doctest/doctest.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <thread>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cca/base/file.hpp>

#include "mock.hpp"

using config_test::controller;
namespace fs = std::filesystem;

namespace {

struct folder {
  fs::path path = fs::temp_directory_path() / ("cca_config_" + std::to_string(::getpid()));
  folder() { fs::create_directories(path); }
  ~folder() { fs::remove_all(path); }
  std::string operator/(std::string_view name) const { return (path / name).string(); }
  auto files() const { return std::distance(fs::directory_iterator(path), {}); }
};

std::string contents(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

// What the writer of this number writes: of a length and of letters of its own.
std::string text_of(int writer) {
  return std::string(static_cast<std::size_t>(10'000 * (writer + 1)), static_cast<char>('a' + writer));
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
    CHECK_EQ(here.files(), 1);
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

  TEST_CASE("several processes and threads may save to one file: who reads it finds one of them, whole") {
    const folder here;
    const std::string file = here / "trot.toml";
    cca::detail::write_file(file, text_of(0));
    const pid_t other = ::fork();
    if (other == 0) {
      for (int i = 0; i < 200; ++i) cca::detail::write_file(file, text_of(1));
      ::_exit(0);
    }
    std::atomic<bool> is_over{false};
    std::thread third([&] {
      while (!is_over) cca::detail::write_file(file, text_of(2));
    });
    int torn = 0, status = 1;
    bool seen[3] = {};
    while (::waitpid(other, &status, WNOHANG) == 0)
      for (int i = 0; i < 20; ++i) {
        const std::string text = cca::detail::read_file(file);
        const int writer = text.empty() ? 0 : text[0] - 'a';
        if (writer >= 0 && writer < 3 && text == text_of(writer)) seen[writer] = true;
        else ++torn;
      }
    is_over = true;
    third.join();
    CHECK_EQ(status, 0);
    CHECK_EQ(torn, 0);
    CHECK((seen[1] && seen[2]));
    CHECK_EQ(here.files(), 1);
  }

  TEST_CASE("what is left of a killed process is in nobody's way, and a file keeps its permissions") {
    const folder here;
    const std::string file = here / "trot.toml";
    const controller c;
    c.save(file);
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
    for (int i = 0; i < 1000; ++i)  // the names that come next
      std::ofstream(file + "." + std::to_string(::getpid()) + "." + std::to_string(i) + ".new");
    const auto before = here.files();
    for (int i = 0; i < 3; ++i) c.save(file);
    CHECK_EQ(contents(file), c.text());
    CHECK_EQ(here.files(), before);
    CHECK_EQ(static_cast<unsigned>(fs::status(file).permissions()), 0640u);
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
    CHECK_EQ(here.files(), 1);
  }

}  // TEST_SUITE
