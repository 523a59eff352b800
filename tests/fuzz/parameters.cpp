// A file of parameters: it is refused with its name and changes nothing, or it is loaded, and what is saved
// then gives the same values.
#include <cstdint>
#include <string>

#include "../runtime/config/mock.hpp"
#include "must.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  config_test::controller c;
  const std::string before = c.text();
  if (const std::string words = c.refusal(text); !words.empty()) {
    fuzz::must(words.starts_with("trot.toml:") && c.text() == before);
    return 0;
  }
  config_test::controller again;
  const std::string saved = c.text();
  fuzz::must(again.refusal(saved).empty() && again.text() == saved);
  return 0;
}
