// Reads and writes whole files. A write that fails leaves the old file as it was.
#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

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

inline void write_file(const std::string& file, std::string_view text) {
  // Writes through links, and into devices without replacing them.
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  const bool special = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  auto target = std::filesystem::weakly_canonical(file, error).string();
  if (error) target = file;
  const std::string fresh = special ? target : target + ".new";
  open_file out(std::fopen(fresh.c_str(), "wb"));
  if (!out) refuse_file(file, "cannot be written", errno);
  bool done =
      std::fwrite(text.data(), 1, text.size(), out.get()) == text.size() && std::fflush(out.get()) == 0;
  int failure = errno;
  done = std::fclose(out.release()) == 0 && done;
  if (done && !special && std::rename(fresh.c_str(), target.c_str()) != 0) {
    failure = errno;
    done = false;
  }
  if (done) return;
  if (!special) std::remove(fresh.c_str());
  refuse_file(file, "cannot be written", failure);
}

}  // namespace cca::detail
