// How the compilers differ, but for what makes a beat fast: that is in inlining.hpp. No other header asks
// which compiler it is; docs/compilers.md lists every workaround, with what was measured.
//
// First it refuses, in a sentence, a language or a compiler in which cca can't be compiled. Without it the
// compiler would print thousands of lines, or crash. #error alone does not stop a compiler; a missing file
// does. Errors: compiler.too_old.
#pragma once

#if __cplusplus < 202002L
#error "compiler.too_old: cca is written in C++20: compile with -std=c++20 or later"
#include <cca/base/the_error_above_says_what_cca_needs>
#endif

#if defined(__apple_build_version__)
#elif defined(__clang__) && __clang_major__ < 17
#error "compiler.too_old: cca needs clang 17 or later, since clang 16 crashes on it; clang 19 is tested"
#include <cca/base/the_error_above_says_what_cca_needs>
#elif !defined(__clang__) && defined(__GNUC__) && __GNUC__ < 12
#error "compiler.too_old: cca needs g++ 12 or later; g++ 12 is tested"
#include <cca/base/the_error_above_says_what_cca_needs>
#endif

// CCA_SANITIZED: 1 with a sanitizer, which adds code to each access of memory.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define CCA_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define CCA_SANITIZED 1
#endif
#endif
#ifndef CCA_SANITIZED
#define CCA_SANITIZED 0
#endif

#include <cstdint>
#include <utility>

namespace cca::detail {

// A text in a template argument: clang prints its first 35 letters, g++ prints all of it.
#if defined(__clang__)
inline constexpr bool prints_whole_texts = false;
#else
inline constexpr bool prints_whole_texts = true;
#endif

// Makes the compiler forget what it knows of an object: it has stored everything before, and reads it again
// after. Both know that the content of a place is undefined until a constructor has written it, and would
// drop what was stored there before.
inline void forget_content(void* place) { asm volatile("" : : "r"(place) : "memory"); }

// CCA_EXACT, the first line of a function body, and kept(a * b): the product is rounded before it is added to
// anything, also where the machine could do both at once. Each compiler has its own way. A square root
// without the call that would set errno. Why: math/rounding.hpp.
#if defined(__clang__)
#define CCA_EXACT _Pragma("clang fp contract(off)")
template <class T>
[[gnu::always_inline]] constexpr T kept(T product) {
  return product;
}
#else
#define CCA_EXACT
template <class T>
[[gnu::always_inline]] inline constexpr T kept(T product) {
  return __builtin_assoc_barrier(product);
}
#endif

inline double square_root_of(double x) {
#if defined(__SSE2__)
  using pair = double __attribute__((vector_size(16)));
#if defined(__clang__)
  return __builtin_elementwise_sqrt(pair{x, 0})[0];
#else
  return __builtin_ia32_sqrtpd(pair{x, 0})[0];
#endif
#else
  return __builtin_sqrt(x);
#endif
}
template <class Lanes>  // a vector of doubles
[[gnu::always_inline]] inline Lanes square_roots_of(Lanes x) {
#if defined(__clang__)
  return __builtin_elementwise_sqrt(x);
#else
#if defined(__AVX__)
  using together = double __attribute__((vector_size(32)));
  if constexpr (sizeof(Lanes) == sizeof(together)) return __builtin_ia32_sqrtpd256(x);
#endif
  for (unsigned i = 0; i < sizeof(Lanes) / sizeof(double); ++i) x[i] = square_root_of(x[i]);
  return x;
#endif
}

// As many doubles as the machine computes at once.
#if defined(__AVX2__)
inline constexpr int lane_count = 4;
#else
inline constexpr int lane_count = 2;
#endif
using lanes = double __attribute__((vector_size(lane_count * sizeof(double))));
// A number of lanes that a template states. g++ 12 loses the attribute in `using`.
template <int N>
struct some_lanes {
  typedef double vector __attribute__((vector_size(N * sizeof(double))));      // NOLINT(modernize-use-using)
  typedef std::int64_t mask __attribute__((vector_size(N * sizeof(double))));  // NOLINT(modernize-use-using)
};

// Both halves of a vector.
template <class Lanes, int... I>
[[gnu::always_inline]] constexpr auto halves_of(Lanes x, std::integer_sequence<int, I...>) {
  struct both {
    decltype(__builtin_shufflevector(x, x, I...)) first, second;
  };
  return both{__builtin_shufflevector(x, x, I...),
              __builtin_shufflevector(x, x, (I + static_cast<int>(sizeof...(I)))...)};
}

// nth_type<List>::at<I>: a type of a list. clang has a builtin for it, g++ 12 has not.
template <class List>
struct nth_type;
#if defined(__has_builtin) && __has_builtin(__type_pack_element)
inline constexpr bool has_nth_type = true;
template <template <class...> class List, class... Types>
struct nth_type<List<Types...>> {
  template <int I>
  using at = __type_pack_element<I, Types...>;
};
#else
inline constexpr bool has_nth_type = false;
#endif

}  // namespace cca::detail
