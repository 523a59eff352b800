// A file of a policy: the bytes as they are, and as the numbers after the head of a right file. It is
// refused and changes nothing, or the weights are finite and the same when they are written and read again.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include <unistd.h>

#include <cca/cca.hpp>
#include <cca/mapping/policy.hpp>

#include "memory_file.hpp"

namespace {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}};
};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<50>> {};
struct walk : cca::policy<cca::policy_inputs<cca::in<"angles", leg_angles>>,
                          cca::hidden_layers<3>,
                          cca::hyperbolic_tangent,
                          leg_angles> {};

std::string text_of(const walk& policy) {
  static const std::string file =
      (std::filesystem::temp_directory_path() / ("cca_fuzz_policy_" + std::to_string(::getpid()))).string();
  policy.save(file);
  std::string text = cca::detail::read_file(file);
  std::filesystem::remove(file);
  return text;
}

bool read(const fuzz::memory_file& file, const std::string& text, walk& policy) {
  file.holds(text.data(), text.size());
  const auto before = policy.weights.weights;
  try {
    policy.read(file.name());
  } catch (const cca::refused& e) {
    fuzz::must(std::string_view(e.what()).starts_with(file.name()) && policy.weights.weights == before);
    return false;
  }
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::memory_file file;
  static const std::string head = [] {
    const std::string text = text_of(walk{});
    return text.substr(0, text.find("numbers "));
  }();
  walk policy{}, again{};
  std::string text(reinterpret_cast<const char*>(data), size);
  read(file, text, policy);
  text = head + text + "\n";
  text += "checksum " + cca::detail::checksum_of(text) + "\n";
  if (!read(file, text, policy)) return 0;
  for (const double w : policy.weights.weights) fuzz::must(std::isfinite(w));
  const std::string written = text_of(policy);
  fuzz::must(read(file, written, again) && again.weights.weights == policy.weights.weights);
  return 0;
}
