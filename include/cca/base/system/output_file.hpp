// A file that a program writes piece by piece, beside its target: the target keeps its old content until the
// new one is complete.
//
//   cca::output_file file("run.mcap");   // opens and locks run.mcap.part; run.mcap stays as it is
//   file.write(bytes);                   // any number of times
//   file.keep();                         // run.mcap.part becomes run.mcap
//   file.discard();                      // or: run.mcap.part goes, run.mcap stays
//
// What a program that crashed has left in run.mcap.part is never overwritten: the next writer of run.mcap
// moves it to run.mcap.part.1, or the next free number. Without keep() and discard() the part stays, unless
// it is empty. Links are followed. A device or a pipe is written directly, without part and lock.
//
// Errors: cca::refused if another program, or this one, is writing the file; std::system_error of open, write
// and rename. For whole files there is write_file (file.hpp). Test: tests/runtime/programs/files.cpp.
#pragma once

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cca/base/refused.hpp>

namespace cca {
namespace detail {

// Where a name leads, by all links; also if nothing is there yet.
inline std::filesystem::path followed(std::filesystem::path file) {
  std::error_code error;
  for (int links = 0; links < 40 && std::filesystem::is_symlink(file, error); ++links) {
    const auto to = std::filesystem::read_symlink(file, error);
    file = to.is_absolute() ? to : file.parent_path() / to;
  }
  const auto whole = std::filesystem::weakly_canonical(std::filesystem::absolute(file, error), error);
  return error ? file : whole;
}

// A device, a pipe: it has no content of its own that could be lost.
inline bool is_special(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
         !std::filesystem::is_directory(status);
}

// Locked; -1: errno says why.
inline int open_locked(const std::string& name, int flags) {
  for (;;) {
    const int file = ::open(name.c_str(), flags | O_RDWR | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file < 0) return -1;
    // Some network file systems have no locks: then there is none.
    if (::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(file);
      errno = EWOULDBLOCK;
      return -1;
    }
    struct stat locked{}, named{};
    const bool is_named = ::fstat(file, &locked) == 0 && ::stat(name.c_str(), &named) == 0 &&
                          locked.st_dev == named.st_dev && locked.st_ino == named.st_ino;
    if (is_named) return file;
    ::close(file);  // its writer has renamed it meanwhile
  }
}

}  // namespace detail

// Moves away what a program that crashed has left beside this file. The new name; empty: nothing was left.
inline std::string set_aside_part(const std::string& name) {
  const std::string part = detail::followed(name).string() + ".part";
  const int file = detail::open_locked(part, 0);
  if (file < 0) return {};
  struct stat found{};
  std::string aside;
  if (::fstat(file, &found) == 0 && found.st_size > 0) {
    std::error_code error;
    for (int number = 1; aside.empty() || std::filesystem::exists(aside, error); ++number)
      aside = part + '.' + std::to_string(number);
    if (::rename(part.c_str(), aside.c_str()) != 0) aside.clear();
  }
  ::close(file);
  return aside;
}

class output_file {
public:
  explicit output_file(std::string name)
      : called(std::move(name)), target(detail::followed(called).string()) {
    if (detail::is_special(target)) {
      file = ::open(target.c_str(), O_WRONLY | O_CLOEXEC);
    } else {
      part = target + ".part";
      // What another writer left since the look is set aside too.
      struct stat found{};
      for (int tries = 0; tries < 3; ++tries) {
        set_aside_part(called);
        file = detail::open_locked(part, O_CREAT);
        if (file < 0 || ::fstat(file, &found) != 0 || found.st_size == 0) break;
        ::close(std::exchange(file, -1));
        errno = EEXIST;
      }
      if (file < 0 && errno == EWOULDBLOCK)
        throw refused(called +
                      ": it is being written by another program, or twice by this one: choose another "
                      "name");
    }
    if (file < 0) fail("can't be opened");
  }
  output_file(const output_file&) = delete;
  output_file& operator=(const output_file&) = delete;
  ~output_file() {
    if (file < 0) return;
    if (size == 0) discard();
    else ::close(file);
  }

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const auto written = ::write(file, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail("can't be written");
      size += static_cast<std::size_t>(written);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  // The file is complete.
  void keep() {
    const int lock = part.empty() ? -1 : ::dup(file);  // closing can fail: so before the old file goes
    bool done = ::close(std::exchange(file, -1)) == 0;
    if (done && !part.empty()) done = ::rename(part.c_str(), target.c_str()) == 0;
    const int error = errno;
    if (lock >= 0) ::close(lock);
    errno = error;
    if (!done) fail("can't be written");
  }
  void discard() {
    if (file < 0) return;
    if (!part.empty()) ::unlink(part.c_str());
    ::close(std::exchange(file, -1));
  }

  bool is_open() const { return file >= 0; }
  // Where the bytes are until keep(): "run.mcap.part".
  const std::string& written_to() const { return part.empty() ? target : part; }

private:
  [[noreturn]] void fail(const char* what) const {
    throw std::system_error(errno, std::generic_category(), called + ' ' + what);
  }

  std::string called, target, part{};  // part is empty: written directly
  int file = -1;
  std::size_t size = 0;
};

}  // namespace cca
