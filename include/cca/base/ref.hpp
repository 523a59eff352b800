// A pointer to a constant, or nothing, which remembers whether it points without comparing addresses. With
// -fsanitize=undefined, g++ 12 can't compare the address of an inline variable with null in a constant
// expression (GCC bug 71962).
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
