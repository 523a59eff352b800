// The readings of the sensor board as the trunk's record (cca/robots/oncilla/spaces.hpp).
//
// A field that the board has not sent yet is not a number. The contacts come in the frame of the angular
// velocity, so they are known when that is. Cost: copying some numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

#include <cca/hardware/oncilla/sensor_board.hpp>
#include <cca/robots/oncilla/spaces.hpp>

namespace cca::hardware {

inline robots::oncilla::measured_trunk::vector_type trunk_record_of(const board_reading& board) {
  using record = robots::oncilla::trunk_record;
  robots::oncilla::measured_trunk::vector_type v;
  const auto copy = [](const auto& numbers, auto part) {
    static_assert(std::tuple_size_v<std::remove_cvref_t<decltype(numbers)>> ==
                  decltype(part)::SizeAtCompileTime);
    std::ranges::copy(numbers, part.begin());
  };
  copy(board.orientation, record::part<"orientation">(v));
  copy(board.angular_velocity, record::part<"angular_velocity">(v));
  copy(board.specific_force, record::part<"acceleration">(v));
  copy(board.foot_load, record::part<"foot_loads">(v));
  copy(board.abduction, record::part<"abducted">(v));
  const double unknown = board.angular_velocity[0] * 0;  // 0, or not a number
  auto contacts = record::part<"contacts">(v);
  for (std::size_t leg = 0; leg < board.contact.size(); ++leg)
    contacts[static_cast<Eigen::Index>(leg)] = (board.contact[leg] ? 1 : 0) + unknown;
  return v;
}

}  // namespace cca::hardware
