// Shared by the tests of this folder: a module that was taught a shape, in a controller.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <cca/adaptive/adaptive_component.hpp>
#include <cca/adaptive/tracking.hpp>
#include <cca/motor/dmp_rhythmic_module.hpp>
#include <cca/motor/hopf.hpp>

#include "../motor/rig.hpp"

namespace adaptive_test {

using motor_test::hip;
using motor_test::knee;
using motor_test::leg;
using motor_test::stride;

// A temporary file for each name, removed at the end.
struct temporary {
  std::string path;
  explicit temporary(const std::string& name)
      : path((std::filesystem::temp_directory_path() / ("cca_" + std::to_string(::getpid()) + "_" + name))
                 .string()) {}
  ~temporary() { std::filesystem::remove(path); }
  temporary(const temporary&) = delete;
  temporary& operator=(const temporary&) = delete;
  std::string text() const {
    std::ostringstream all;
    all << std::ifstream(path, std::ios::binary).rdbuf();
    return all.str();
  }
  void write(const std::string& text) const { std::ofstream(path, std::ios::binary) << text; }
};

template <class F>
std::string words_of(F f) {
  try {
    f();
  } catch (const cca::refused& refusal) { return refusal.what(); }
  return {};
}

}  // namespace adaptive_test
