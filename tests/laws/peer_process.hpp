// Another program as a child process, and what it prints.
#pragma once

#include <doctest/doctest.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

class peer_process {
public:
  // The program and its arguments.
  explicit peer_process(std::vector<std::string> words) {
    std::vector<char*> letters;
    for (auto& word : words) letters.push_back(word.data());
    letters.push_back(nullptr);
    int ends[2];
    REQUIRE_EQ(::pipe(ends), 0);
    child = ::fork();
    if (child == 0) {
      ::dup2(ends[1], STDOUT_FILENO);
      ::close(ends[0]);
      ::execv(letters[0], letters.data());
      ::_exit(127);
    }
    ::close(ends[1]);
    from = ends[0];
    ::fcntl(from, F_SETFL, O_NONBLOCK);
  }
  ~peer_process() {
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(from);
  }
  peer_process(const peer_process&) = delete;
  peer_process& operator=(const peer_process&) = delete;

  // Whether it has printed a line, which is its last.
  bool has_said() {
    char some[1024];
    for (ssize_t size; (size = ::read(from, some, sizeof some)) > 0;)
      said.append(some, static_cast<std::size_t>(size));
    return said.ends_with('\n');
  }
  std::string said;

private:
  pid_t child = 0;
  int from = -1;
};
