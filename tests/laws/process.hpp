// A part of a test that runs in another process, and what it says at its end.
#pragma once

#include <doctest/doctest.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <exception>
#include <iostream>
#include <string>

class process {
public:
  // f gives a text, or throws.
  template <class F>
  explicit process(F f) {
    int ends[2];
    REQUIRE_EQ(::pipe(ends), 0);
    std::cout.flush();  // else the other process writes it too
    child = ::fork();
    if (child == 0) {
      std::string text;
      try {
        text = f();
      } catch (const std::exception& e) { text = std::string("refused: ") + e.what(); }
      const auto size = ::write(ends[1], text.data(), text.size());
      ::_exit(size == static_cast<ssize_t>(text.size()) ? 0 : 1);
    }
    ::close(ends[1]);
    from = ends[0];
  }
  std::string said() {
    std::string all;
    char some[4096];
    for (ssize_t size; (size = ::read(from, some, sizeof some)) > 0;)
      all.append(some, static_cast<std::size_t>(size));
    wait();
    return all;
  }
  void kill() {
    ::kill(child, SIGKILL);
    wait();
  }
  void stop() const { ::kill(child, SIGSTOP); }
  // Until it has stopped itself.
  void wait_until_it_stands() const {
    int status = 0;
    REQUIRE_EQ(::waitpid(child, &status, WUNTRACED), child);
    REQUIRE(WIFSTOPPED(status));
  }
  void go_on() const { ::kill(child, SIGCONT); }
  ~process() {
    if (child > 0) kill();
    ::close(from);
  }
  process(const process&) = delete;
  process& operator=(const process&) = delete;

private:
  void wait() {
    if (child > 0) ::waitpid(child, nullptr, 0);
    child = 0;
  }

  pid_t child = 0;
  int from = -1;
};
