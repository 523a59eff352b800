#pragma once
// Another process of this program. It is ended with the object, if it has not ended by itself.
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <stdexcept>
#include <string>
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
    if (::posix_spawn(&id, "/proc/self/exe", nullptr, nullptr, words.data(), environ) != 0)
      throw std::runtime_error("no further process can be started");
  }
  process(process&& other) noexcept : id(other.id) { other.id = 0; }
  ~process() {
    if (id == 0) return;
    ::kill(id, SIGTERM);
    wait();
  }

  // Its exit code; -1 if a signal ended it.
  int wait() {
    int status = 0;
    ::waitpid(id, &status, 0);
    id = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

private:
  pid_t id = 0;
};

}  // namespace deployed
