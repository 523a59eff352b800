// A component that may have to stop the robot returns a fault: empty, or a reason. The reason is not copied,
// so give it a literal.
#pragma once

#include <cca/base/compiler.hpp>

namespace cca {

class fault {
public:
  constexpr fault() = default;
  constexpr fault(const char* reason) : why(reason) {}

  explicit constexpr operator bool() const { return why != nullptr; }
  constexpr const char* reason() const { return why ? why : ""; }

private:
  const char* why = nullptr;
};

}  // namespace cca
