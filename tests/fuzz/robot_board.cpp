// Random bytes as frames of a robot's board: a frame that it does not take changes nothing; what it takes is
// of one measurement, within its ranges, and survives encoding and decoding.
#include <algorithm>

#include <cca/hardware/robot/boards/robot_board.hpp>

#include "decoding.hpp"

using namespace cca::hardware;

namespace {

using board = robot_board<0x40, 2, 1>;

// Numbers that are not known are sent as 0. The most negative number is never sent, so one step.
template <std::size_t N>
bool near(const std::array<double, N>& sent, const std::array<double, N>& known, auto step) {
  for (std::size_t i = 0; i < N; ++i)
    if (!(std::fabs(sent[i] - (std::isnan(known[i]) ? 0 : known[i])) <= 1.001 * step(i))) return false;
  return true;
}

double load_step(std::size_t i) { return i < 3 ? board::torque_step : board::force_step; }
double speed_step(std::size_t) { return board::speed_step; }
double acceleration_step(std::size_t) { return board::acceleration_step; }

void survives_encoding(const board::reading& r) {
  auto again = board::reading::untold();
  const bool turned = !std::isnan(r.inertial[0].orientation[0]);
  constexpr std::size_t orientation = 2 * board::sensors;  // its place; without one it is refused
  const auto frames = board::frames(r, 7);
  for (std::size_t i = 0; i < frames.size(); ++i)
    fuzz::must(frames[i].valid() && board::decode(frames[i], again) == (i != orientation || turned));
  for (std::size_t k = 0; k < board::sensors; ++k) fuzz::must(near(again.loads[k], r.loads[k], load_step));
  fuzz::must(near(again.inertial[0].angular_velocity, r.inertial[0].angular_velocity, speed_step));
  fuzz::must(near(again.inertial[0].specific_force, r.inertial[0].specific_force, acceleration_step));
  // Half a step, and the error of its length.
  if (turned)
    fuzz::must(
        near(again.inertial[0].orientation, r.inertial[0].orientation, [](std::size_t) { return 2e-4; }));
  fuzz::must(again.status == r.status && again.frames == 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto r = board::reading::untold();
  for (std::size_t first = 0; first == 0 || first + 14 <= size; first += 14) {
    const can_frame f = fuzz::bytes_of_frame{data + first, size - first}.frame(board::replies);
    const auto before = r;
    if (!board::decode(f, r)) {
      fuzz::must(std::memcmp(&before, &r, sizeof r) == 0);
    } else {
      fuzz::must(r.frames == before.frames || r.frames == before.frames + 1);
    }
    for (std::size_t k = 0; k < board::sensors; ++k) {
      fuzz::must((r.complete[k] == 0) == std::isnan(r.loads[k][0]));
      for (std::size_t i = 0; i < 6; ++i)
        fuzz::must(std::isnan(r.loads[k][i]) ? r.complete[k] == 0
                                             : std::fabs(r.loads[k][i]) <=
                                                   32768 * (i < 3 ? board::torque_step : board::force_step));
    }
    const cca::robots::inertial_reading& unit = r.inertial[0];
    fuzz::must((r.complete[board::sensors] == 0) == std::isnan(unit.specific_force[0]));
    double square = 0;
    for (const double x : unit.orientation) square += x * x;
    fuzz::must(std::isnan(square) || std::fabs(square - 1) < 1e-12);
    survives_encoding(r);
  }
  return 0;
}
