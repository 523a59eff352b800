// A pointer to a constant, or nothing, which remembers whether it points without comparing addresses: under
// -fsanitize=undefined such a comparison may be refused in a constant expression (docs/compilers.md).
#pragma once

#include <cca/base/compiler.hpp>

#include <cstddef>

namespace cca::detail {

template <class Type>
class ref {
public:
  constexpr ref() = default;
  constexpr ref(std::nullptr_t) {}
  constexpr ref(const Type* existing) : to(existing), engaged(true) {}

  explicit constexpr operator bool() const { return engaged; }
  constexpr operator const Type*() const { return to; }
  constexpr const Type* operator->() const { return to; }
  constexpr const Type& operator*() const { return *to; }
  constexpr const Type& operator[](int i) const { return to[i]; }

private:
  const Type* to = nullptr;
  bool engaged = false;
};

}  // namespace cca::detail
