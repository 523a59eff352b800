// A file in POSIX shared memory that only this user may open, and the locks of its bytes. A lock belongs to
// this object, not to the process; the system takes it away when the process ends.
//
// What another program has put there is refused, and left as it is: a file of ours begins with `mark`. An
// empty one is taken, because a process may have been killed right after it made it.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include <cca/base/monotonic_clock.hpp>
#include <cca/base/refused.hpp>
#include <cca/runtime/transports/lock_holder.hpp>

namespace cca::detail {

class shared_file {
public:
  static constexpr std::string_view mark = "cca shm";

  explicit shared_file(std::string name) : path(std::move(name)) {
    if (path.size() < 2 || path[0] != '/' || path.find('/', 1) != std::string::npos)
      refuse(" is no name: write a slash and letters, as \"/trot\"");
    open();
  }
  ~shared_file() { ::close(file); }
  shared_file(const shared_file&) = delete;
  shared_file& operator=(const shared_file&) = delete;

  // Locks the byte `at`. False: another process holds it.
  bool lock(long at) const {
    auto one = lock_of(F_WRLCK, at, 1);
    return ::fcntl(file, F_OFD_SETLK, &one) == 0;
  }
  void unlock(long at) const {
    auto one = lock_of(F_UNLCK, at, 1);
    ::fcntl(file, F_OFD_SETLK, &one);
  }
  // Does another process hold it?
  bool is_locked(long at) const { return is_locked(file, at); }
  // For a message: ": process 4711 (walk)", or nothing.
  std::string holder_of(long at) const {
    struct stat of{};
    const int id = ::fstat(file, &of) == 0 ? holder_of_lock(of, at) : 0;
    return id == 0 ? "" : ": process " + described_process(id);
  }

  // Waits for the lock of a byte, at most so long (ns). False: another process holds it all the time.
  bool wait_for(long at, std::int64_t longest) const {
    const std::int64_t since = monotonic_clock::now();
    while (!lock(at)) {
      const std::int64_t now = monotonic_clock::now();
      if (now - since >= longest) return false;
      monotonic_clock::sleep_until(now + 1'000'000);
    }
    return true;
  }
  // The same, of the file that has the name then: another process may have removed this one meanwhile.
  void wait_for_named(long at, std::int64_t longest) {
    for (;;) {
      if (!wait_for(at, longest))
        refuse(": another process has held its lock for " + std::to_string(longest / 1'000'000'000) +
               " s, so it hangs or is stopped: let it go on, or end it" + holder_of(at));
      if (is_named()) return;
      ::close(std::exchange(file, -1));
      open();
    }
  }

  // Is it still the file with this name? `rm` removes the name, and so does systemd at logout (RemoveIPC).
  bool is_named() const {
    return with_named([&](int named) { return is_this(named); });
  }
  // Another file has the name now, and a process holds this byte of it.
  bool is_locked_in_successor(long at) const {
    return with_named([&](int named) { return !is_this(named) && is_locked(named, at); });
  }

  std::size_t size() const {
    struct stat of{};
    return ::fstat(file, &of) == 0 ? static_cast<std::size_t>(of.st_size) : 0;
  }
  // Zeros after `mark`, which is there first: if this process is killed meanwhile, the next one knows the
  // file. All of its memory is there then; without that, a full /dev/shm would kill whoever writes into it.
  void make_anew(std::size_t size) const {
    int error = ::ftruncate(file, 0) != 0 ||
                        ::pwrite(file, mark.data(), mark.size(), 0) != static_cast<ssize_t>(mark.size())
                    ? errno
                    : 0;
    while (error == 0 && (error = ::posix_fallocate(file, 0, static_cast<off_t>(size))) == EINTR) error = 0;
    if (error != 0)
      refuse(" can't be given its " + std::to_string(size) + " bytes of /dev/shm: " + std::strerror(error));
  }
  void* map(std::size_t size) const {
    void* const at = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (at == MAP_FAILED) fail("can't be mapped");
    return at;
  }
  // Its name, where that is still its own.
  void remove() const {
    if (is_named()) ::shm_unlink(path.c_str());
  }
  const std::string& name() const { return path; }

  // `what` goes on after the name: " is ...", ": ...".
  [[noreturn]] void refuse(const std::string& what) const {
    throw refused("cca::shared_memory: `" + path + '`' + what);
  }

private:
  void open() {
    do {
      file = ::shm_open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW, 0);
      if (file < 0 && errno == ENOENT)
        file = ::shm_open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600);
    } while (file < 0 && errno == EEXIST);
    if (file < 0) fail("can't be opened");
    try {
      check();
    } catch (...) {
      ::close(std::exchange(file, -1));
      throw;
    }
  }
  void check() const {
    struct stat of{};
    if (::fstat(file, &of) != 0) fail("can't be looked at");
    if (of.st_uid != ::geteuid() || (of.st_mode & 077) != 0)
      refuse(" belongs to somebody else, or others may open it: take another name");
    char begins[mark.size()];
    const ssize_t there = S_ISREG(of.st_mode) ? ::pread(file, begins, sizeof begins, 0) : -1;
    if (there != 0 && (there != sizeof begins || std::string_view(begins, sizeof begins) != mark))
      refuse(" is a file of another program: take another name, or remove /dev/shm" + path);
  }
  template <class F>
  bool with_named(F f) const {
    const int named = ::shm_open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW, 0);
    if (named < 0) return false;
    const bool is_so = f(named);
    ::close(named);
    return is_so;
  }
  bool is_this(int other) const {
    struct stat own{}, of{};
    return ::fstat(file, &own) == 0 && ::fstat(other, &of) == 0 && own.st_dev == of.st_dev &&
           own.st_ino == of.st_ino;
  }
  static bool is_locked(int in, long at) {
    auto one = lock_of(F_WRLCK, at, 1);
    return ::fcntl(in, F_OFD_GETLK, &one) == 0 && one.l_type != F_UNLCK;
  }
  static struct flock lock_of(short type, long at, long count) {
    struct flock one{};
    one.l_type = type;
    one.l_whence = SEEK_SET;
    one.l_start = at;
    one.l_len = count;
    return one;
  }
  [[noreturn]] void fail(const char* what) const {
    refuse(' ' + std::string(what) + ": " + std::strerror(errno));
  }

  std::string path;
  int file = -1;
};

}  // namespace cca::detail
