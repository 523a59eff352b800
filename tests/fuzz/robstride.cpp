#include <cca/hardware/virtual_robstride.hpp>

#include "decoding.hpp"

using namespace cca::hardware;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using hip = robstride<rs04, 3>;
  fuzz::hears<hip>(data, size);
  fuzz::hears<robstride<cybergear, 127, 0>>(data, size);
  // The drive's side: a command that is heard is within the ranges, and survives encoding.
  const can_frame f = fuzz::bytes_of_frame{data, size}.frame(hip::requests);
  drive_command c;
  if (hip::hear(f, c)) {
    const auto again = hip::set_point(c);
    fuzz::must(again.cut == 0 && again.frames.size() == 1 && again.frames[0] == f);
  }
  virtual_robstride<hip> v;
  v.hear(f, 0);
  for (const can_frame& out : v.answer({})) fuzz::must(out.valid());
  return 0;
}
