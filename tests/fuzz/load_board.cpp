// Random bytes as frames of the load board: a frame that it does not take changes nothing; a load that it
// takes is of one measurement, within its ranges, and survives encoding and decoding.
#include <cca/hardware/robot/load_board.hpp>

#include "decoding.hpp"

using namespace cca::hardware;

namespace {

using board = load_board<0x40, 2>;

void survives_encoding(const board::reading& r) {
  auto again = board::reading::untold();
  for (const can_frame& f : board::frames(r, 7)) fuzz::must(f.valid() && board::decode(f, again));
  // The most negative number is never sent, so one step.
  for (std::size_t k = 0; k < board::sensors; ++k)
    for (std::size_t i = 0; i < 6; ++i)
      fuzz::must(std::fabs(again.loads[k][i] - (std::isnan(r.loads[k][i]) ? 0 : r.loads[k][i])) <=
                 1.001 * (i < 3 ? board::torque_step : board::force_step));
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
    survives_encoding(r);
  }
  return 0;
}
