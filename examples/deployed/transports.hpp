#pragma once
// What connects the processes of a run. To add a transport, add its name and its line here.
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include <cca/dds.hpp>
#include <cca/main/command_line.hpp>
#include <cca/runtime/transports/shared_memory.hpp>

namespace deployed {

inline constexpr std::array<std::string_view, 2> transport_names{"shared_memory", "dds"};
inline constexpr std::uint32_t dds_domain = 7;

// Calls f(transport). `address` is a number: only processes with the same one find each other.
template <class F>
auto with_transport(const std::string& name, const std::string& address, F f) {
  if (name == "shared_memory") return f(cca::shared_memory("/cca_deployed_" + address));
  if (name == "dds") return f(cca::dds::domain(dds_domain, "cca_deployed_" + address));
  throw cca::command_line_error(name + ": no transport between processes");
}

}  // namespace deployed
