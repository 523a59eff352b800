// What Debian's libc++ for WebAssembly lacks and the library's reading of files needs. It is included before
// all else (CMakeLists.txt), so no header knows of it.
#pragma once

#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace std {

// As strict as the real one about what begins a number: no spaces, no plus. strtod rounds correctly, too.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string text(first, last);
  if (text.empty() || text[0] == ' ' || text[0] == '+' || text[0] == '\t' || text[0] == '\n')
    return {first, errc::invalid_argument};
  char* end = nullptr;
  const double read = strtod(text.c_str(), &end);
  if (end == text.c_str()) return {first, errc::invalid_argument};
  value = read;
  return {first + (end - text.c_str()), errc()};
}

// There is one thread, so a lock guards nothing.
class mutex {
public:
  void lock() noexcept {}
  void unlock() noexcept {}
  bool try_lock() noexcept { return true; }
};
template <class... Mutexes>
class scoped_lock {
public:
  explicit scoped_lock(Mutexes&...) noexcept {}
  ~scoped_lock() {}
  scoped_lock(const scoped_lock&) = delete;
  scoped_lock& operator=(const scoped_lock&) = delete;
};

// Only a writer of traces waits for another thread, and no page has one.
namespace this_thread {

inline void yield() noexcept {}
template <class Duration>
void sleep_for(const Duration&) {}

}  // namespace this_thread

// There is one folder, and nothing is written.
namespace filesystem {

inline path current_path(error_code&) { return path("/"); }
inline file_status status(const path&, error_code&) { return file_status(file_type::not_found); }
inline bool exists(file_status s) { return s.type() != file_type::not_found; }
inline bool is_regular_file(file_status s) { return s.type() == file_type::regular; }
inline path weakly_canonical(const path& p, error_code&) { return p; }

}  // namespace filesystem
}  // namespace std

// No file is written, so none needs permissions.
inline int fchmod(int, unsigned) { return 0; }
