// A program in a process of its own: what it writes, how it ends, and signals to it.
#pragma once

#include <doctest/doctest.h>

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

namespace programs_test {

class child {
public:
  // main(count, words), the first word is the name of the program.
  template <class Main>
  child(Main main, std::vector<std::string> arguments) {
    int output[2], errors[2];
    REQUIRE_EQ(::pipe(output), 0);
    REQUIRE_EQ(::pipe(errors), 0);
    std::cout.flush();
    std::fflush(nullptr);
    id = ::fork();
    if (id == 0) {
      ::dup2(output[1], 1);
      ::dup2(errors[1], 2);
      for (const int file : {output[0], output[1], errors[0], errors[1]}) ::close(file);
      arguments.insert(arguments.begin(), "/bin/walk");
      std::vector<char*> words;
      for (auto& each : arguments) words.push_back(each.data());
      const int code = main(static_cast<int>(words.size()), words.data());
      std::cout.flush();
      std::fflush(nullptr);
      ::_exit(code);
    }
    ::close(output[1]);
    ::close(errors[1]);
    files[0] = output[0], files[1] = errors[0];
  }
  ~child() {
    if (id > 0) {
      ::kill(id, SIGKILL);
      ::waitpid(id, nullptr, 0);
    }
    for (const int file : files)
      if (file >= 0) ::close(file);
  }
  child(const child&) = delete;
  child& operator=(const child&) = delete;

  void send(int signal) const { ::kill(id, signal); }
  // Waits until it has written this on its standard output.
  void wait_for(const std::string& what) { wait_for(what, out); }
  // Or on its error output.
  void wait_for_error(const std::string& what) { wait_for(what, err); }
  // Nobody reads its standard output any more, as of `walk | head`.
  void stop_reading() {
    ::close(files[0]);
    files[0] = -1;
  }
  // Waits for its end: its exit code, or 128 and the signal that killed it.
  int code() {
    while (read_some()) {}
    int status = 0;
    ::waitpid(id, &status, 0);
    id = 0;
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }

  std::string out{}, err{};

private:
  void wait_for(const std::string& what, const std::string& in) {
    while (in.find(what) == in.npos && read_some()) {}
    CHECK(in.find(what) != in.npos);
  }
  bool read_some() {
    pollfd both[2] = {{files[0], POLLIN, 0}, {files[1], POLLIN, 0}};
    if (::poll(both, 2, 60'000) <= 0) return false;
    bool any = false;
    for (int i = 0; i < 2; ++i) {
      char some[4096];
      if (both[i].revents == 0) continue;
      const ssize_t size = ::read(files[i], some, sizeof some);
      if (size > 0) (i == 0 ? out : err).append(some, static_cast<std::size_t>(size)), any = true;
    }
    const bool has_out_ended = files[0] < 0 || (both[0].revents & POLLHUP) != 0;
    return any || !has_out_ended || (both[1].revents & POLLHUP) == 0;
  }

  pid_t id = 0;
  int files[2] = {-1, -1};
};

}  // namespace programs_test
