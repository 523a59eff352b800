#pragma once
// What connects the processes of a run. To add a transport, add its name and its line here.
#include <array>
#include <string>
#include <string_view>

#include <cca/runtime/environments/shared_memory.hpp>

#include "../trot/report/option_reader.hpp"

namespace deployed {

inline constexpr std::array<std::string_view, 1> transport_names{"shared_memory"};

// Calls f(transport). `address` is a number: only processes with the same one find each other.
template <class F>
auto with_transport(const std::string& name, const std::string& address, F f) {
  if (name == "shared_memory") return f(cca::shared_memory("/cca_deployed_" + address));
  throw trot::command_line_error(name + ": no transport between processes");
}

}  // namespace deployed
