// A file in POSIX shared memory that only this user may open, and the locks of its bytes. A lock belongs to
// this object, not to the process; the system takes it away when the process ends.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <string>
#include <utility>

#include <cca/base/refused.hpp>

namespace cca::detail {

class shared_file {
public:
  explicit shared_file(std::string name) : path(std::move(name)) {
    if (path.size() < 2 || path[0] != '/' || path.find('/', 1) != std::string::npos)
      throw refused("cca::shared_memory: `" + path + "` is no name: write a slash and letters, as \"/trot\"");
    file = ::shm_open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (file < 0) fail("can't be opened");
    struct stat of{};
    if (::fstat(file, &of) != 0) fail("can't be looked at");
    if (of.st_uid != ::geteuid() || (of.st_mode & 077) != 0) {
      ::close(file);
      throw refused("cca::shared_memory: `" + path +
                    "` belongs to somebody else, or others may open it: take "
                    "another name");
    }
  }
  ~shared_file() { ::close(file); }
  shared_file(const shared_file&) = delete;
  shared_file& operator=(const shared_file&) = delete;

  // Locks the byte `at`; if `waits`, blocks until it is free. False: another process holds it.
  bool lock(long at, bool waits) const {
    auto one = lock_of(F_WRLCK, at, 1);
    while (::fcntl(file, waits ? F_OFD_SETLKW : F_OFD_SETLK, &one) != 0)
      if (errno != EINTR) return false;
    return true;
  }
  void unlock(long at) const {
    auto one = lock_of(F_UNLCK, at, 1);
    ::fcntl(file, F_OFD_SETLK, &one);
  }
  // Does another process hold one of these bytes?
  bool is_locked(long at, long count) const {
    auto one = lock_of(F_WRLCK, at, count);
    return ::fcntl(file, F_OFD_GETLK, &one) == 0 && one.l_type != F_UNLCK;
  }

  std::size_t size() const {
    struct stat of{};
    return ::fstat(file, &of) == 0 ? static_cast<std::size_t>(of.st_size) : 0;
  }
  void resize(std::size_t size) const {
    if (::ftruncate(file, 0) != 0 || ::ftruncate(file, static_cast<off_t>(size)) != 0)
      fail("can't be made larger");
  }
  void* map(std::size_t size) const {
    void* const at = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (at == MAP_FAILED) fail("can't be mapped");
    return at;
  }
  void remove() const { ::shm_unlink(path.c_str()); }
  const std::string& name() const { return path; }

private:
  static struct flock lock_of(short type, long at, long count) {
    struct flock one{};
    one.l_type = type;
    one.l_whence = SEEK_SET;
    one.l_start = at;
    one.l_len = count;
    return one;
  }
  [[noreturn]] void fail(const char* what) const {
    throw refused("cca::shared_memory: `" + path + "` " + what + ": " + std::strerror(errno));
  }

  std::string path;
  int file = -1;
};

}  // namespace cca::detail
