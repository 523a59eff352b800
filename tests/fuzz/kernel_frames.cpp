// What the kernel gives us: frames, and error frames, which change the bus's state.
#include <cstdlib>
#include <cstring>

#include <cca/hardware/bus/kernel_frame.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cca::hardware;
  bus_state s = bus_state::active;
  bus_counters c;
  for (std::size_t first = 0; first < size; first += sizeof(::can_frame)) {
    canfd_frame k{};
    std::memcpy(&k, data + first, size - first < sizeof k ? size - first : sizeof k);
    for (const std::size_t length : {detail::classic_size, detail::fd_size}) {
      cca::hardware::can_frame f;
      detail::from_kernel(k, length, f);
      if (!f.id.valid() || f.length > (f.fd ? 64 : 8)) std::abort();
    }
    const std::uint64_t restarts = c.restarts;
    const bool was_off = s == bus_state::bus_off;
    s = detail::after_error(s, k, c);
    if (was_off && s != bus_state::bus_off && c.restarts == restarts)
      std::abort();  // only a restart ends bus-off
  }
  if (c.bus_offs < c.restarts) std::abort();
  return 0;
}
