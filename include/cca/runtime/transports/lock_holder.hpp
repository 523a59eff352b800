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

// Is f(path) true for an entry of a folder? A process may end meanwhile, then its entries are gone.
template <class F>
bool is_any_entry(const std::filesystem::path& folder, F f) {
  std::error_code failed;
  std::filesystem::directory_iterator at(folder, failed);
  for (; !failed && at != std::filesystem::directory_iterator{}; at.increment(failed))
    if (f(at->path())) return true;
  return false;
}

// 0: it is not known, as of a process with capabilities.
inline int holder_of_lock(const struct stat& of, long byte) {
  const auto says_so = [&](const std::filesystem::path& facts_of_file) {
    std::ifstream facts(facts_of_file);
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
    return false;
  };
  int holder = 0;
  is_any_entry("/proc", [&](const std::filesystem::path& process) {
    const std::string name = process.filename();
    int id = 0;
    if (std::from_chars(name.data(), name.data() + name.size(), id).ptr != name.data() + name.size())
      return false;
    if (!is_any_entry(process / "fdinfo", says_so)) return false;
    holder = id;
    return true;
  });
  return holder;
}

}  // namespace cca::detail
