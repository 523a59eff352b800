// A URDF file: there is a header, or an error says why not.
#include <algorithm>
#include <cstdint>
#include <string_view>

#include "../../tools/urdf/conversion.hpp"
#include "must.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const bool floats : {false, true}) {
    const cca_urdf::conversion c = cca_urdf::convert(text, {.floats = floats});
    fuzz::must(!c.header.empty() ||
               std::ranges::any_of(c.said, [](const cca_urdf::remark& r) { return r.is_error; }));
  }
  return 0;
}
