// What is asked for from outside and has effect in all environments of a deployment in one beat
// (environments/links/agreed_changes.hpp).
#pragma once

#include <cstdint>

namespace cca::detail {

enum class ordered : std::uint8_t { stop, start, mode };

}  // namespace cca::detail
