// A program of tests/ros2_peers, as a child process.
#pragma once

#include <doctest/doctest.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "spaces.hpp"

namespace ros2_test {

class peer {
public:
  peer(const char* program, const std::string& what, const std::string& type, const std::string& topic) {
    int ends[2];
    REQUIRE_EQ(::pipe(ends), 0);
    child = ::fork();
    if (child == 0) {
      ::dup2(ends[1], STDOUT_FILENO);
      ::close(ends[0]);
      ::execl(program, program, what.c_str(), domain().c_str(), type.c_str(), topic.c_str(),
              static_cast<char*>(nullptr));
      ::_exit(127);
    }
    ::close(ends[1]);
    from = ends[0];
    ::fcntl(from, F_SETFL, O_NONBLOCK);
  }
  ~peer() {
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(from);
  }
  peer(const peer&) = delete;
  peer& operator=(const peer&) = delete;

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

inline constexpr const char* idlc_peer = CCA_IDLC_PEER;
inline constexpr const char* fast_dds_peer = CCA_FAST_DDS_PEER;

}  // namespace ros2_test
