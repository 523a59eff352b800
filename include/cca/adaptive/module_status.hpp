// Module Status: what the learner of a module is doing, and whether the input of the module lies in its
// trained region (the source document, section 4.4.4).
//
//   out<"module", module_status_port>     over learning_axis (a cca::learning) and region_axis (a
//                                         cca::trained_region)
//   status.as<cca::learning>(cca::learning_axis{}) == cca::learning::trained
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <cca/space/methods/scalar.hpp>
#include <cca/space/space.hpp>

namespace cca {

enum class learning : std::uint8_t { idle, collecting, online, batch, trained };
enum class trained_region : std::uint8_t { outside, inside };

constexpr std::string_view to_string(learning state) {
  constexpr std::array<std::string_view, 5> names{"idle", "collecting", "learning online", "learning batch",
                                                  "trained"};
  return names[static_cast<std::size_t>(state)];
}
constexpr std::string_view to_string(trained_region state) {
  return state == trained_region::inside ? "inside" : "outside";
}

struct learning_axis : dimension<"learning"> {};
struct region_axis : dimension<"region"> {};
struct module_status_port : space<status, axes<learning_axis, region_axis>> {};

// The value of the status port.
inline module_status_port::vector_type status_of(learning state, trained_region region) {
  return {status_of(state), status_of(region)};
}

// A request of another component to a module: `optional_in<"learn", learning_request>`.
enum class learning_call : std::uint8_t { nothing, collect, learn, rest, forget };
struct call_axis : dimension<"call"> {};
struct learning_request : space<status, axes<call_axis>> {};

}  // namespace cca
