// Nobody runs an environment twice over shared memory, whatever happens to the name of the memory; and what
// else can lie under the name, or holds its lock, is refused in words.
#include <doctest/doctest.h>

#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <cca/runtime/transports/shared_memory.hpp>

#include "robot_and_mind.hpp"

using namespace deployment_test;
using cca::detail::shared_file;

namespace {

std::string fresh_name() {
  static int number = 0;
  return "/cca_names_" + std::to_string(::getpid()) + "_" + std::to_string(number++);
}
std::string path_of(const std::string& name) { return "/dev/shm" + name; }
bool is_there(const std::string& name) { return ::access(path_of(name).c_str(), F_OK) == 0; }

struct opened {
  cca::deployed<two> robot;
  opened(const std::string& name, const char* environment)
      : robot(cca::only{environment}, cca::shared_memory(name)) {}
};
std::string refusal_of(const std::string& name, const char* environment) {
  try {
    const opened one(name, environment);
  } catch (const cca::refused& refusal) { return refusal.what(); }
  return "nothing";
}
bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// A process of its own, which ends when this does.
class other_process {
public:
  template <class F>
  explicit other_process(F f) {
    REQUIRE_EQ(::pipe(pipe), 0);
    id = ::fork();
    if (id == 0) {
      ::dup2(pipe[1], STDERR_FILENO);
      ::_exit(f());
    }
    ::close(pipe[1]);
  }
  ~other_process() {
    end();
    ::close(pipe[0]);
  }
  other_process(const other_process&) = delete;
  other_process& operator=(const other_process&) = delete;

  // Waits until it has written this on its error output; what it has written.
  std::string wait_for(const std::string& what) {
    pollfd one{pipe[0], POLLIN, 0};
    for (char some[4096]; !has(text, what) && ::poll(&one, 1, 30'000) > 0;) {
      const ssize_t size = ::read(pipe[0], some, sizeof some);
      if (size <= 0) break;
      text.append(some, static_cast<std::size_t>(size));
    }
    return text;
  }
  void end() {
    if (id > 0) ::kill(id, SIGKILL), ::waitpid(id, nullptr, 0);
    id = 0;
  }
  int code() {
    int status = 0;
    ::waitpid(id, &status, 0);
    id = 0;
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }
  std::string process() const { return "process " + std::to_string(id) + " ("; }

private:
  pid_t id = 0;
  int pipe[2] = {-1, -1};
  std::string text{};
};
void say(const std::string& what) { static_cast<void>(!::write(STDERR_FILENO, what.data(), what.size())); }

// Runs an environment until it is killed.
int run_for_ever(const std::string& name, const char* environment) {
  const opened one(name, environment);
  say("runs;");
  for (;;) ::pause();
}

constexpr long setup_byte = 0, byte_of_robot = 1;

}  // namespace

TEST_SUITE("names of shared memory") {
  TEST_CASE("who waits while the last process removes the memory begins again with the name") {
    const std::string name = fresh_name();
    std::optional<shared_file> last(std::in_place, name);
    last->wait_for_named(setup_byte, 1'000'000'000);
    std::atomic<bool> has_opened{false}, is_named{false};
    std::thread next([&] {
      shared_file file(name);
      has_opened = true;
      file.wait_for_named(setup_byte, 30'000'000'000);
      is_named = file.is_named();
      file.remove();
    });
    while (!has_opened) std::this_thread::yield();
    last->remove();
    last.reset();
    next.join();
    CHECK(is_named);
    CHECK_FALSE(is_there(name));
  }

  TEST_CASE("processes that come and go in a hurry never run one environment twice") {
    const std::string name = fresh_name();
    auto* const running = static_cast<std::atomic<int>*>(
        ::mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    const auto hurry = [&] {
      for (int i = 0; i < 150; ++i) try {
          const opened one(name, "robot");
          if (running->fetch_add(1) != 0) return 1;
          running->fetch_sub(1);
        } catch (const cca::refused& refusal) {
          if (!has(refusal.what(), "another process runs environment `robot` already")) return 2;
        }
      return 0;
    };
    other_process a(hurry), b(hurry), c(hurry);
    for (other_process* one : {&a, &b, &c}) CHECK_EQ(one->code(), 0);
    CHECK_FALSE(is_there(name));
    ::munmap(running, sizeof(std::atomic<int>));
  }

  TEST_CASE("a removed name keeps a second process away as long as the first runs, which says so") {
    const std::string name = fresh_name();
    other_process robot([&] { return run_for_ever(name, "robot"); });
    other_process mind([&] { return run_for_ever(name, "mind"); });
    robot.wait_for("runs;");
    mind.wait_for("runs;");
    ::unlink(path_of(name).c_str());
    for (const auto& [environment, runs] : {std::pair{"robot", &robot}, std::pair{"mind", &mind}}) {
      const std::string said = refusal_of(name, environment);
      CHECK(has(said, "another process runs environment `" + std::string(environment) +
                          "` already, in a memory of this name that was removed meanwhile: end it: " +
                          runs->process()));
      CHECK_FALSE(is_there(name));
    }
    for (other_process* one : {&robot, &mind})
      CHECK(has(one->wait_for("\n"), "runs;cca::shared_memory: `" + name +
                                         "` was removed while it is used (by rm, or by systemd at logout"));
    robot.end();
    // One that runs alone there would never meet it.
    CHECK(has(refusal_of(name, "robot"), "another process runs environment `mind` already, in a memory"));
  }

  TEST_CASE("a killed process is followed by the next one, at once") {
    const std::string name = fresh_name();
    for (int i = 0; i < 20; ++i) {
      {
        other_process robot([&] { return run_for_ever(name, "robot"); });
        robot.wait_for("runs;");
      }
      CHECK_EQ(refusal_of(name, "robot"), "nothing");
    }
  }

  TEST_CASE("who is refused leaves the memory to those that use it") {
    const std::string name = fresh_name();
    const opened robot(name, "robot");
    CHECK(has(refusal_of(name, "robot"), "another process runs environment `robot` already"));
    CHECK(is_there(name));
    CHECK_EQ(refusal_of(name, "mind"), "nothing");
    CHECK(is_there(name));
  }

  TEST_CASE("where a second process came in all the same, the run ends, and there is no other") {
    const std::string name = fresh_name();
    cca::deployed<two> d(cca::only{"robot", "mind"}, cca::shared_memory(name));
    d.load();
    d.start();
    std::optional<shared_file> successor;
    const auto between = [&](auto&) {
      if (d.beat_index() == 20) {  // as from another container, with which it shares only /dev/shm
        ::unlink(path_of(name).c_str());
        successor.emplace(name);
        successor->lock(byte_of_robot);
      }
      ::usleep(1000);
      return true;
    };
    CHECK_EQ(d.run(cca::for_<60>{}, {}, between), cca::state::started);
    CHECK_LT(d.beat_index(), 50'000);
    CHECK_THROWS_WITH_AS(d.run(cca::for_<60>{}),
                         ("cca::shared_memory: `" + name +
                          "`: another process runs environment `robot` too, in a memory made after this one")
                             .c_str(),
                         cca::refused);
    successor->unlock(byte_of_robot);
    successor->remove();
  }

  TEST_CASE("a file of another program is refused and left as it is") {
    for (const std::string text : {"!", "#!/bin/sh\nexit\n", "cca is mentioned here"}) {
      const std::string name = fresh_name();
      std::ofstream(path_of(name)) << text;
      ::chmod(path_of(name).c_str(), 0600);
      CHECK_EQ(refusal_of(name, "robot"),
               "cca::shared_memory: `" + name +
                   "` is a file of another program: take another name, or remove /dev/shm" + name);
      std::ifstream in(path_of(name));
      CHECK_EQ(std::string(std::istreambuf_iterator<char>(in), {}), text);
      ::unlink(path_of(name).c_str());
    }
  }

  TEST_CASE("what a process leaves that was killed while it made its memory is begun anew") {
    for (const std::string text : {"", "cca shm", "cca shm1 and some more"}) {
      const std::string name = fresh_name();
      std::ofstream(path_of(name)) << text;
      ::chmod(path_of(name).c_str(), 0600);
      CHECK_EQ(refusal_of(name, "robot"), "nothing");
      CHECK_FALSE(is_there(name));
    }
  }

  TEST_CASE("a full /dev/shm is refused, and nothing stays there") {
    const std::string name = fresh_name();
    other_process poor([&] {
      if ((::unshare(CLONE_NEWNS) != 0 && ::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) ||
          ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
          ::mount("small", "/dev/shm", "tmpfs", 0, "size=8k") != 0)
        return 2;
      say(refusal_of(name, "robot") + ";");
      return is_there(name) ? 1 : 0;
    });
    const std::string said = poor.wait_for(";");
    const int code = poor.code();
    if (code == 2) {
      MESSAGE("NOT TESTED HERE, this process may mount nothing");
      return;
    }
    CHECK_EQ(code, 0);
    CHECK(said.starts_with("cca::shared_memory: `" + name + "` can't be given its "));
    CHECK(has(said, " bytes of /dev/shm: No space left on device"));
  }

  TEST_CASE("who hangs with the lock is named, and holds nobody up for ever") {
    const std::string name = fresh_name();
    other_process hangs([&] {
      shared_file file(name);
      file.lock(setup_byte);
      say("holds it;");
      ::raise(SIGSTOP);
      return 0;
    });
    hangs.wait_for("holds it;");
    const std::string said = refusal_of(name, "robot");
    CHECK(has(said, "`" + name +
                        "`: another process has held its lock for 5 s, so it hangs or is stopped: let it go "
                        "on, or end it: " +
                        hangs.process()));
    ::unlink(path_of(name).c_str());
  }
}
