// The mistake of a board that has no ids for its frames.
#pragma once

#include <cstddef>
#include <cstdint>

#include <cca/base/messages/holds_or_tells.hpp>

namespace cca::hardware::detail {

template <std::uint32_t Base, std::size_t Frames>
struct ids_of_board {
  static constexpr void tell(auto& m) {
    if (Frames == 0)
      m << "drive.bad_number: the board at the id " << static_cast<std::int64_t>(Base)
        << " has no sensor, so it would send nothing: leave it out, or give it loads or inertial units";
    else
      m << "drive.bad_number: a board of " << static_cast<std::int64_t>(Frames)
        << " frames with the first id " << static_cast<std::int64_t>(Base) << " has the ids up to "
        << static_cast<std::int64_t>(Base + Frames - 1)
        << ", and the last of 11 bits is 2047: let it begin at a lower one";
  }
};

}  // namespace cca::hardware::detail
