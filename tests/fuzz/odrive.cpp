#include <cca/hardware/odrive.hpp>

#include "decoding.hpp"

using namespace cca::hardware;

namespace {

template <class D>
void hears(const std::uint8_t* data, std::size_t size) {
  fuzz::hears<D>(data, size);
  drive_command c;
  const std::array<can_filter, 1> input{{{D::id(D::input)}}};
  D::hear(fuzz::bytes_of_frame{data, size}.frame(input), c);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hears<odrive<1, odrive_mode::position>>(data, size);
  hears<odrive<2, odrive_mode::velocity>>(data, size);
  hears<odrive<0x1234, odrive_mode::torque>>(data, size);
  hears<odrive<4, odrive_mode::position, odrive_firmware::v0_5>>(data, size);
  return 0;
}
