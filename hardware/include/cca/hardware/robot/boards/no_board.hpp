// For robots without a sensor board: a board that sends and hears nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <cca/hardware/drives/drive.hpp>

namespace cca::hardware {

struct no_board {
  struct reading {
    std::uint8_t status = 0;
    std::uint64_t frames = 0;
    static constexpr reading untold() { return {}; }
  };

  static constexpr std::string_view name = "no board";
  static constexpr std::size_t bus = 0;
  static constexpr bit_rates rates{};
  static constexpr std::array<can_filter, 0> requests{}, replies{};
  static constexpr std::array<frame_traffic, 0> traffic{};

  static constexpr bool decode(const can_frame&, reading&) noexcept { return false; }
  static constexpr std::array<can_frame, 0> frames(const reading&, std::uint8_t) noexcept { return {}; }
};

}  // namespace cca::hardware
