// A program that was run: what it wrote, and how it ended.
#pragma once

#include <doctest/doctest.h>

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>
#include <utmp.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace door_tools_test {

using words = std::vector<std::string>;

[[noreturn]] inline void become(const std::string& program,
                                const words& arguments,
                                const words& environment) {
  ::close_range(3, ~0U, 0);  // also the door of the test: else its port stays taken
  std::vector<std::string> all{program};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers, variables;
  for (auto& one : all) pointers.push_back(one.data());
  pointers.push_back(nullptr);
  std::vector<std::string> kept = environment;
  for (auto& one : kept) variables.push_back(one.data());
  variables.push_back(nullptr);
  ::execve(program.c_str(), pointers.data(), variables.data());
  ::_exit(127);
}

struct ran {
  int code = -1;
  std::string out{}, err{};
};

// A program that runs, with its output in pipes.
class running {
public:
  running(const std::string& program, const words& arguments, const words& environment = {}) {
    int output[2], errors[2];
    REQUIRE_EQ(::pipe2(output, O_CLOEXEC), 0);
    REQUIRE_EQ(::pipe2(errors, O_CLOEXEC), 0);
    id = ::fork();
    if (id == 0) {
      ::dup2(output[1], 1);
      ::dup2(errors[1], 2);
      become(program, arguments, environment);
    }
    ::close(output[1]);
    ::close(errors[1]);
    files[0] = output[0], files[1] = errors[0];
  }
  running(const running&) = delete;
  running& operator=(const running&) = delete;
  ~running() {
    if (id > 0) ::kill(id, SIGKILL), ::waitpid(id, nullptr, 0);
    for (const int file : files) ::close(file);
  }
  void send(int signal) const { ::kill(id, signal); }
  bool writes(const std::string& text) {
    while (all.out.find(text) == text.npos && all.err.find(text) == text.npos)
      if (!read_some()) return false;
    return true;
  }
  ran end() {
    while (read_some()) {}
    int status = 0;
    ::waitpid(std::exchange(id, 0), &status, 0);
    all.code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    return all;
  }

private:
  pid_t id = 0;
  int files[2] = {-1, -1};
  ran all{};

  bool read_some() {
    pollfd both[2] = {{files[0], POLLIN, 0}, {files[1], POLLIN, 0}};
    if (::poll(both, 2, 20'000) <= 0) return false;
    bool any = false;
    for (int i = 0; i < 2; ++i) {
      char some[4096];
      if (both[i].revents == 0) continue;
      const ssize_t size = ::read(files[i], some, sizeof some);
      if (size > 0) (i == 0 ? all.out : all.err).append(some, static_cast<std::size_t>(size)), any = true;
    }
    return any || (both[0].revents & POLLHUP) == 0 || (both[1].revents & POLLHUP) == 0;
  }
};

// In a terminal of its own. `shown` is what it has written since, codes included.
class in_terminal {
public:
  in_terminal(const std::string& program,
              const words& arguments,
              const words& environment,
              int width = 80,
              int height = 24) {
    winsize size{};
    size.ws_col = static_cast<unsigned short>(width), size.ws_row = static_cast<unsigned short>(height);
    int master = -1, slave = -1;
    REQUIRE_EQ(::openpty(&master, &slave, nullptr, nullptr, &size), 0);
    ::fcntl(master, F_SETFD, FD_CLOEXEC);
    ::fcntl(slave, F_SETFD, FD_CLOEXEC);
    ::tcgetattr(slave, &before);
    file = master, kept = slave;  // kept: its settings are looked at when the program is gone
    id = ::fork();
    if (id == 0) {
      ::login_tty(slave);
      become(program, arguments, environment);
    }
  }
  in_terminal(const in_terminal&) = delete;
  in_terminal& operator=(const in_terminal&) = delete;
  ~in_terminal() {
    if (id > 0) ::kill(id, SIGKILL), ::waitpid(id, nullptr, 0);
    ::close(file);
    ::close(kept);
  }

  std::string shown{};

  void type(const std::string& keys) const {
    CHECK_EQ(::write(file, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }
  void send(int signal) const { ::kill(id, signal); }
  void resize(int width, int height) const {
    winsize size{};
    size.ws_col = static_cast<unsigned short>(width), size.ws_row = static_cast<unsigned short>(height);
    ::ioctl(file, TIOCSWINSZ, &size);
  }
  // Within ten seconds; what came before it is forgotten.
  bool shows(const std::string& text) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    for (;;) {
      if (const std::size_t at = shown.find(text); at != text.npos) {
        shown.erase(0, at + text.size());
        return true;
      }
      pollfd one{file, POLLIN, 0};
      if (std::chrono::steady_clock::now() > end) return false;
      if (::poll(&one, 1, 100) <= 0) continue;
      char some[4096];
      const ssize_t size = ::read(file, some, sizeof some);
      if (size <= 0) return false;
      shown.append(some, static_cast<std::size_t>(size));
    }
  }
  int end() {
    int status = 0;
    ::waitpid(std::exchange(id, 0), &status, 0);
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }
  bool is_as_before() const {
    termios now{};
    ::tcgetattr(kept, &now);
    return now.c_lflag == before.c_lflag && now.c_iflag == before.c_iflag;
  }

private:
  pid_t id = 0;
  int file = -1, kept = -1;
  termios before{};
};

}  // namespace door_tools_test
