#include <cca/hardware/mit.hpp>

#include "decoding.hpp"

using namespace cca::hardware;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::hears<mit_drive<ak80_9, 3>>(data, size);
  fuzz::hears<mit_drive<ak80_6, 7, 0x100, mit_firmware::original>>(data, size);
  fuzz::hears<mit_drive<ak70_10, 5, 0x15, mit_firmware::damiao>>(data, size);
  // The drive's side: any eight bytes are a special frame, or a command that survives decoding and encoding.
  if (size >= 8) {
    using wire = mit_wire<ak80_9>;
    const auto w = wire::read(std::span<const std::uint8_t, 8>(data, 8));
    std::uint8_t cut = 0;
    const auto again = wire::to_wire(wire::from_wire(w), cut);
    bool special = true;
    for (std::size_t i = 0; i < 7; ++i) special &= data[i] == 0xFF;
    fuzz::must(cut == 0 && (special || again == w));
  }
  return 0;
}
