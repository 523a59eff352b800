// Which process holds a lock of a file, for a message. The system names no owner of such a lock, so this
// looks through the open files of the processes of this user.
#pragma once

#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace cca::detail {

// "4711 (walk)".
inline std::string described_process(int id) {
  std::ifstream file("/proc/" + std::to_string(id) + "/comm");
  std::string name;
  std::getline(file, name);
  return std::to_string(id) + (name.empty() ? "" : " (" + name + ")");
}

// 0: it is not known, as of a process with capabilities.
inline int holder_of_lock(const struct stat& of, long byte) {
  namespace fs = std::filesystem;
  const auto holds_it = [&](const fs::path& open_files) {
    std::error_code denied;
    for (const auto& one : fs::directory_iterator(open_files, denied)) {
      std::ifstream facts(one.path());
      for (std::string line; std::getline(facts, line);) {
        unsigned device[2] = {};
        unsigned long inode = 0;
        long first = 0;
        if (std::sscanf(line.c_str(), "lock: %*d: %*s %*s %*s %*d %x:%x:%lu %ld", &device[0], &device[1],
                        &inode, &first) == 4 &&
            device[0] == major(of.st_dev) && device[1] == minor(of.st_dev) && inode == of.st_ino &&
            first == byte)
          return true;
      }
    }
    return false;
  };
  std::error_code denied;
  for (const auto& process : fs::directory_iterator("/proc", denied)) {
    const std::string name = process.path().filename();
    int id = 0;
    if (std::from_chars(name.data(), name.data() + name.size(), id).ptr != name.data() + name.size())
      continue;
    if (holds_it(process.path() / "fdinfo")) return id;
  }
  return 0;
}

}  // namespace cca::detail
