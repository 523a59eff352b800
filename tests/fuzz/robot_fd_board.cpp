// Random bytes as CAN FD frames of a robot's board: a frame that it does not take changes nothing; what it
// takes is one whole reading, within its ranges, and survives encoding and decoding.
#include <algorithm>

#include <cca/hardware/robot/boards/robot_fd_board.hpp>

#include "decoding.hpp"

using namespace cca::hardware;

namespace {

using board = robot_fd_board<0x40, 2, 1>;

template <std::size_t N>
bool is_in_range(const std::array<double, N>& numbers, double step) {
  return std::ranges::all_of(numbers, [&](double x) { return std::fabs(x) <= 32768 * step; });
}

void survives_encoding(const board::reading& r) {
  auto again = board::reading::untold();
  for (const can_frame& f : board::frames(r, 0)) fuzz::must(f.valid() && board::decode(f, again));
  const auto near = [](const auto& a, const auto& b, double step) {
    for (std::size_t i = 0; i < a.size(); ++i) fuzz::must(std::fabs(a[i] - b[i]) <= 1.001 * step);
  };
  for (std::size_t k = 0; k < board::sensors; ++k) near(again.loads[k], r.loads[k], board::force_step);
  near(again.inertial[0].angular_velocity, r.inertial[0].angular_velocity, board::speed_step);
  near(again.inertial[0].specific_force, r.inertial[0].specific_force, board::acceleration_step);
  near(again.inertial[0].orientation, r.inertial[0].orientation, 2e-4);  // half a step, and its length
  fuzz::must(again.status == r.status && again.frames == 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto r = board::reading::untold();
  for (std::size_t first = 0; first == 0 || first + 30 <= size; first += 30) {
    const can_frame f = fuzz::bytes_of_frame{data + first, size - first}.frame(board::replies);
    const auto before = r;
    if (!board::decode(f, r)) {
      fuzz::must(std::memcmp(&before, &r, sizeof r) == 0);
    } else {
      fuzz::must(f.fd && (f.length == 16 || f.length == 24));
      fuzz::must(r.frames == *std::ranges::min_element(r.complete));
    }
    for (std::size_t k = 0; k < board::sensors; ++k)
      fuzz::must(r.complete[k] == 0 ? std::isnan(r.loads[k][0]) : is_in_range(r.loads[k], board::force_step));
    const cca::robots::inertial_reading& unit = r.inertial[0];
    if (r.complete[board::sensors] == 0) {
      fuzz::must(std::isnan(unit.orientation[0]) && std::isnan(unit.specific_force[0]));
    } else {
      double square = 0;
      for (const double x : unit.orientation) square += x * x;
      fuzz::must(std::fabs(square - 1) < 1e-12);
      fuzz::must(is_in_range(unit.angular_velocity, board::speed_step) &&
                 is_in_range(unit.specific_force, board::acceleration_step));
    }
    if (r.frames > 0) survives_encoding(r);
  }
  return 0;
}
