// Reads and writes whole files. A write goes into a new file of its own beside the old one, which then takes
// its place: who reads finds the old text or the new one, whole, also if several write at once, a write
// fails, or the power goes.
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <cca/base/refused.hpp>

namespace cca::detail {

struct close_file {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using open_file = std::unique_ptr<std::FILE, close_file>;

[[noreturn]] inline void refuse_file(const std::string& file, std::string_view what, int error) {
  std::error_code failed;
  const auto here = std::filesystem::current_path(failed).string();
  const bool relative = std::filesystem::path(file).is_relative();
  throw refused(file + ": " + std::string(what) + ": " + std::strerror(error) +
                (relative ? " (looked in " + here + ")" : ""));
}

// Not more than `most` bytes: a device or a wrong file does not fill the memory.
inline std::string read_file(const std::string& file, std::size_t most = std::size_t{1} << 30) {
  const open_file in(std::fopen(file.c_str(), "rb"));
  if (!in) refuse_file(file, "cannot be read", errno);
  std::string text;
  char block[4096];
  for (std::size_t size; (size = std::fread(block, 1, sizeof block, in.get())) > 0;) {
    text.append(block, size);
    if (text.size() > most)
      throw refused(file + ": has more than " + std::to_string(most >> 20) +
                    " MB, the most that is read of such a file");
  }
  if (std::ferror(in.get())) refuse_file(file, "cannot be read", errno);
  return text;
}

// WebAssembly runs one process.
inline int process_number() {
#ifdef __wasi__
  return 0;
#else
  return ::getpid();
#endif
}

// An empty file beside `target` that nobody else has: "trot.toml.1234.0.new".
struct fresh_file {
  std::string path;
  open_file out;

  explicit fresh_file(const std::string& target) {
    static std::atomic<unsigned> number{0};
    do {
      path = target + '.' + std::to_string(process_number()) + '.' + std::to_string(number++) + ".new";
      out.reset(std::fopen(path.c_str(), "wbxe"));
    } while (!out && errno == EEXIST);
  }
};

// Onto the disk. Where there is none to wait for, as of a pipe, there is nothing to do.
inline bool sync(int file) { return ::fsync(file) == 0 || errno == EINVAL || errno == EROFS; }
inline void sync_folder(const std::string& of) {
  const auto folder = std::filesystem::path(of).parent_path();
  const int at = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (at < 0) return;
  sync(at);  // the file is whole in any case
  ::close(at);
}

inline bool write_all(open_file out, std::string_view text) {
  const bool is_written = std::fwrite(text.data(), 1, text.size(), out.get()) == text.size() &&
                          std::fflush(out.get()) == 0 && sync(::fileno(out.get()));
  const int failure = errno;
  const bool is_closed = std::fclose(out.release()) == 0;
  if (!is_written) errno = failure;
  return is_written && is_closed;
}

// Writes through links, and into devices without replacing them. The new file has the old one's permissions.
inline void write_file(const std::string& file, std::string_view text) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    open_file out(std::fopen(file.c_str(), "wbe"));
    if (!out || !write_all(std::move(out), text)) refuse_file(file, "cannot be written", errno);
    return;
  }
  auto target = std::filesystem::weakly_canonical(file, error).string();
  if (error) target = file;
  fresh_file fresh(target);
  if (!fresh.out) refuse_file(file, "cannot be written", errno);
  if (std::filesystem::exists(status))
    ::fchmod(::fileno(fresh.out.get()), static_cast<mode_t>(status.permissions()) & 07777);
  if (!write_all(std::move(fresh.out), text) || std::rename(fresh.path.c_str(), target.c_str()) != 0) {
    const int failure = errno;
    std::remove(fresh.path.c_str());
    refuse_file(file, "cannot be written", failure);
  }
  sync_folder(target);
}

}  // namespace cca::detail
