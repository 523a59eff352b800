#include <cca/hardware/cia402.hpp>

#include "decoding.hpp"

using namespace cca::hardware;

namespace {

struct motor {
  static constexpr std::string_view name = "EPOS4";
  static constexpr double counts = 4096, torque = 0.8;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::hears<cia402<motor, 5, cia402_mode::position>>(data, size);
  using drive = cia402<motor, 6, cia402_mode::torque>;
  fuzz::hears<drive>(data, size);
  std::uint16_t word = 0;
  drive_command c;
  drive::hear(fuzz::bytes_of_frame{data, size}.frame(drive::requests), word, c);
  return 0;
}
