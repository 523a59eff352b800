// A log of candump: a line is refused with a message, or it is a frame that can be on a bus and stays the
// same when it is written and read again. A whole log is refused, or has the frames of its lines.
#include <sstream>
#include <string>

#include "../../tools/cca_can/commands/replay.hpp"
#include "decoding.hpp"

namespace {

void read_one(const std::string& text) {
  cca_can::log_line line, again;
  const std::string wrong = cca_can::read_line(text, line);
  if (!wrong.empty() || !line.has_frame()) return;
  fuzz::must(line.frame.valid() && line.time >= 0 && !line.bus.empty());
  fuzz::must(cca_can::read_line(cca_can::text_of(line), again).empty() && again.has_frame());
  fuzz::must(again.frame == line.frame && again.bus == line.bus);
  fuzz::must(again.time == line.time / 1000 * 1000);  // the text has microseconds
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  read_one(text);
  std::istringstream file(text);
  try {
    const cca_can::log_file log = cca_can::read_log(file, "log");
    for (const cca_can::log_line& line : log.lines) fuzz::must(line.frame.valid() && !line.bus.empty());
  } catch (const cca::refused& e) { fuzz::must(std::string(e.what()).starts_with("log:")); }
  return 0;
}
