// The rest of a beat, for measurements of code that runs once in it: more code and more data than a cache
// holds.
//
//   bench::other_code work;
//   work.run()         256 KB of instructions, each once: a processor's nearest cache (32 or 64 KB) forgets
//                      the rest of the program
//   work.run_on_data() the same, and 8 MB of data: the second cache (1 to 4 MB) forgets it, too
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace bench {

class other_code {
  static constexpr int functions = 1024, steps = 19;  // of about 14 bytes each

  template <int Function, int... Step>
  [[gnu::always_inline]] static std::uint64_t mixed(std::uint64_t x, std::integer_sequence<int, Step...>) {
    ((x = (x ^ (0x2545f491u + static_cast<std::uint64_t>(Function * 977 + Step))) *
          (0x10000001u + 2u * static_cast<std::uint64_t>(Function * 31 + Step))),
     ...);
    return x;
  }
  template <int Function>
  [[gnu::noinline]] static std::uint64_t part(std::uint64_t x) {
    return mixed<Function>(x, std::make_integer_sequence<int, steps>());
  }
  static constexpr auto all = []<int... Function>(std::integer_sequence<int, Function...>) {
    return std::array<std::uint64_t (*)(std::uint64_t), functions>{&part<Function>...};
  }(std::make_integer_sequence<int, functions>());

  std::uint64_t sum = 1;
  std::vector<std::uint64_t> data = std::vector<std::uint64_t>(std::size_t{1} << 20);

public:
  void run() {
    for (const auto& one : all) sum = one(sum);
  }
  void run_on_data() {
    constexpr std::size_t numbers_in_line = 8;
    for (std::size_t i = 0; i < data.size(); i += numbers_in_line) data[i] += ++sum;
    run();
  }
  std::uint64_t result() const { return sum; }  // so that the work is needed
};

}  // namespace bench
