// Random bytes as a frame of the sensor board: a frame that it does not take changes nothing; a frame that it
// takes gives numbers within its ranges, which survive encoding and decoding.
#include <cca/hardware/sensor_board.hpp>

#include "decoding.hpp"

using namespace cca::hardware;

namespace {

using board = sensor_board<0x40>;

template <std::size_t N>
bool near(const std::array<double, N>& a, const std::array<double, N>& b, double most) {
  for (std::size_t i = 0; i < N; ++i)
    if (!(std::fabs(a[i] - b[i]) <= most)) return false;
  return true;
}
template <std::size_t N>
void must_be_within(const std::array<double, N>& numbers, double step) {
  for (const double x : numbers) fuzz::must(std::fabs(x) <= 32768 * step);
}

void survives_encoding(const board_reading& r) {
  board_reading again;
  for (const can_frame& f : board::frames(r, 7)) fuzz::must(f.valid() && board::decode(f, again));
  // The most negative number is never sent, so one step; of an orientation half a step, and the error of its
  // length.
  fuzz::must(near(again.orientation, r.orientation, 2e-4));
  fuzz::must(near(again.angular_velocity, r.angular_velocity, 1.001 * board::speed_step));
  fuzz::must(near(again.specific_force, r.specific_force, 1.001 * board::force_step));
  fuzz::must(near(again.foot_load, r.foot_load, 1.001 * board::load_step));
  fuzz::must(near(again.abduction, r.abduction, 1.001 * board::angle_step));
  fuzz::must(again.contact == r.contact && again.status == r.status);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  board_reading r;
  std::array<double, 4> targets{};
  for (std::size_t first = 0; first == 0 || first + 14 <= size; first += 14) {
    const fuzz::bytes_of_frame bytes{data + first, size - first};
    const can_frame f = bytes.frame(board::replies);
    const board_reading before = r;
    if (!board::decode(f, r)) {
      fuzz::must(std::memcmp(&before, &r, sizeof r) == 0);
    } else {
      fuzz::must(r.frames == before.frames + 1);
    }
    double square = 0;
    for (const double x : r.orientation) square += x * x;
    fuzz::must(std::fabs(square - 1) < 1e-12);
    must_be_within(r.angular_velocity, board::speed_step);
    must_be_within(r.specific_force, board::force_step);
    must_be_within(r.foot_load, board::load_step);
    must_be_within(r.abduction, board::angle_step);
    survives_encoding(r);

    const auto targets_before = targets;
    if (!board::abducted(bytes.frame(board::requests), targets)) fuzz::must(targets == targets_before);
    must_be_within(targets, board::angle_step);
    auto again = targets;
    fuzz::must(board::abducted(board::abduct(targets), again) &&
               near(again, targets, 1.001 * board::angle_step));
  }
  return 0;
}
