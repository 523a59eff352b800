#include <memory>

#include <cca/hardware/moteus.hpp>

#include "decoding.hpp"

using namespace cca::hardware;

namespace {

struct motor {
  static constexpr std::string_view name = "n1";
  static constexpr double stiffness = 80, damping = 2, torque = 12, timeout = 0.05;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::hears<moteus<motor, 1>>(data, size);
  using servo = moteus<motor, 9>;
  servo::request q;
  servo::hear(fuzz::bytes_of_frame{data, size}.frame(servo::requests), q);
  // In memory of exactly their size.
  const auto exact = std::make_unique<std::uint8_t[]>(size);
  std::memcpy(exact.get(), data, size);
  std::size_t values = 0;
  read_registers({exact.get(), size}, [&values](moteus_kind, std::uint32_t, double number) {
    ++values;
    fuzz::must(!std::isinf(number));
  });
  fuzz::must(values <= size);
  return 0;
}
