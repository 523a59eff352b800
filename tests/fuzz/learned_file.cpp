// A file of learned values, with and without its checksum: it is refused with its name, or its values are
// within their bounds and the same when they are written and read again.
#include <array>
#include <cstdint>
#include <string>

#include <Eigen/Core>

#include <cca/adaptive/learned_file.hpp>
#include <cca/component/parameters.hpp>

#include "must.hpp"

namespace {

enum class way { left, right };
struct inner {
  BOOST_HANA_DEFINE_STRUCT(inner, (std::int8_t, small), (bool, on), (way, to));
};
struct learned {
  BOOST_HANA_DEFINE_STRUCT(learned,
                           (std::array<double, 12>, weights),
                           (cca::bounded<double, 0, 1>, rate),
                           (float, half),
                           (std::int64_t, seen),
                           (inner, rest));
};
constexpr auto& schema = cca::detail::schema_of<learned>;

const cca::learned_header header{"model", "learner", {{"step", 0.001}}, {{"input x", {"angle"}}}};

bool read(const std::string& text, learned& values) {
  try {
    cca::detail::read_learned(text, "file", header, schema, &values);
  } catch (const cca::refused& e) {
    fuzz::must(std::string_view(e.what()).starts_with("file:"));
    return false;
  }
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string text(reinterpret_cast<const char*>(data), size);
  learned values{}, again{};
  read(text, values);
  if (!text.empty() && text.back() != '\n') text += '\n';
  text += "checksum " + cca::detail::checksum_of(text) + "\n";
  if (!read(text, values)) return 0;
  fuzz::must(values.rate >= 0 && values.rate <= 1);
  fuzz::must(values.rest.to == way::left || values.rest.to == way::right);
  const std::string written = cca::detail::learned_text(header, schema, &values);
  fuzz::must(read(written, again) && cca::detail::learned_text(header, schema, &again) == written);
  return 0;
}
