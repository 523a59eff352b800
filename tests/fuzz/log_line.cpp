// A line of candump's log: it is refused with a message, or it is a frame that can be on a bus and stays the
// same when it is written and read again.
#include <string>

#include "../../tools/cca_can/log_line.hpp"
#include "decoding.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  cca_can::log_line line, again;
  const std::string wrong = cca_can::read_line(text, line);
  if (!wrong.empty() || line.error) return 0;
  fuzz::must(line.frame.valid() && line.time >= 0 && !line.bus.empty());
  fuzz::must(cca_can::read_line(cca_can::text_of(line), again).empty() && !again.error);
  fuzz::must(again.frame == line.frame && again.bus == line.bus);
  fuzz::must(again.time == line.time / 1000 * 1000);  // the text has microseconds
  return 0;
}
