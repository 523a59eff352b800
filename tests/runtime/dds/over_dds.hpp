// DDS for tests: a domain and partitions that no other test program of this machine uses at the same time.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <string>

#include <cca/dds.hpp>

struct over_dds {
  static std::uint32_t number() {
    static const auto of_this_program = static_cast<std::uint32_t>(::getpid()) % 200;
    return of_this_program;
  }
  static auto transport(const std::string& name) { return cca::dds::domain(number(), name); }
  static std::string other_name() {
    static int made = 0;
    number();  // before the process is forked
    return "cca_test_" + std::to_string(::getpid()) + "_" + std::to_string(made++);
  }
};
