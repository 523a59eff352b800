// A file of a test, removed at the end. Tests run side by side, so no other test has this one, nor has
// another object of this test.
#pragma once

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <unistd.h>

namespace laws {

class temporary_file {
public:
  const std::string path;

  explicit temporary_file(const std::string& name = {})
      : path((std::filesystem::temp_directory_path() /
              ("cca_" + std::to_string(::getpid()) + "_" + std::to_string(count++) + "_" + name))
                 .string()) {}
  temporary_file(const std::string& name, const std::string& text) : temporary_file(name) { write(text); }
  temporary_file(const temporary_file&) = delete;
  temporary_file& operator=(const temporary_file&) = delete;
  ~temporary_file() { std::filesystem::remove(path); }

  std::string text() const {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void write(const std::string& text) const { std::ofstream(path, std::ios::binary) << text; }

private:
  static inline std::atomic<int> count = 0;
};

}  // namespace laws
