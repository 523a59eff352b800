#pragma once
// Another process of this program. It is ended with the object, if it has not ended by itself.
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

extern char** environ;

namespace deployed {

class process {
public:
  explicit process(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "deployed");
    std::vector<char*> words;
    for (auto& one : arguments) words.push_back(one.data());
    words.push_back(nullptr);
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe to a further process");
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_adddup2(&files, ends[1], STDOUT_FILENO);
    const int failed = ::posix_spawn(&id, "/proc/self/exe", &files, nullptr, words.data(), environ);
    ::posix_spawn_file_actions_destroy(&files);
    ::close(ends[1]);
    output = ends[0];
    if (failed != 0) {
      ::close(output);
      throw std::runtime_error("no further process can be started");
    }
  }
  process(process&& other) noexcept
      : id(std::exchange(other.id, 0)), output(std::exchange(other.output, -1)) {}
  ~process() {
    if (id != 0) {
      ::kill(id, SIGTERM);
      wait();
    }
    if (output >= 0) ::close(output);
  }

  // Its exit code; -1 if a signal ended it.
  int wait() {
    int status = 0;
    read_all();
    ::waitpid(id, &status, 0);
    id = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  // What it has printed, after wait().
  const std::string& printed() const { return text; }

private:
  void read_all() {
    char some[4096];
    for (ssize_t size = 0; (size = ::read(output, some, sizeof some)) != 0;)
      if (size > 0) text.append(some, static_cast<std::size_t>(size));
      else if (errno != EINTR) return;
  }

  pid_t id = 0;
  int output = -1;
  std::string text{};
};

}  // namespace deployed
